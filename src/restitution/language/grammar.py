"""The grammar of a line of a statement (LALR); it contains the grammar of expressions."""

from restitution.expression.grammar import EXPRESSION

STATEMENT = (
    EXPRESSION
    + """
%declare SPHERE WALL POINT LET GIVEN UNKNOWN FIND SHOW HITS RECEIVES REACHES WORD
%declare MASS VELOCITY RADIUS AT_REST ALONG THROUGH CIRCLE CENTRE OFFSET
%declare COLON EQUAL ORDER ALIGN AND AGAIN COLLIDE_AGAIN DOES_NOT_HIT WILL_HIT
%declare RANGE_OF EXTREME_OF OVER PERCENTAGE IN_TERMS_OF FIGURES

?line: SPHERE names -> spheres
    | SPHERE names COLON sphere_properties -> spheres
    | WALL names -> walls
    | WALL names COLON wall_properties -> walls
    | POINT NAME COLON sum -> point
    | NAME HITS NAME -> impact
    | NAME HITS NAME COLON impact_properties -> impact
    | NAME RECEIVES expression -> kick
    | NAME REACHES expression -> arrival
    | LET LETTER EQUAL expression -> let
    | GIVEN relation (COMMA relation)* -> given
    | UNKNOWN LETTER (COMMA LETTER)* -> unknown
    | FIND item (COMMA item)* -> find
    | FIND item (COMMA item)* terms -> find
    | SHOW relation -> show
    | SHOW relation terms -> show
    | SHOW relation FIGURES -> show
    | SHOW relation FIGURES terms -> show
    | SHOW RANGE_OF expression COLON relation -> show_range
    | SHOW RANGE_OF expression COLON relation terms -> show_range
    | SHOW RANGE_OF expression COLON relation FIGURES -> show_range
    | SHOW RANGE_OF expression COLON relation FIGURES terms -> show_range
    | SHOW EXTREME_OF expression OVER expression EQUAL expression -> show_extremum
    | SHOW EXTREME_OF expression OVER expression EQUAL expression terms -> show_extremum
    | SHOW EXTREME_OF expression OVER expression EQUAL expression FIGURES -> show_extremum
    | SHOW EXTREME_OF expression OVER expression EQUAL expression FIGURES terms -> show_extremum

names: NAME (COMMA NAME)*
terms: IN_TERMS_OF LETTER ((COMMA | AND) LETTER)*

sphere_properties: sphere_property (COMMA sphere_property)*
sphere_property: MASS expression
    | VELOCITY expression
    | AT_REST
    | AT sum
    | RADIUS expression
wall_properties: wall_property
    | wall_properties COMMA wall_property
    | wall_properties THROUGH sum
    | wall_properties RADIUS expression
wall_property: ALONG expression
    | THROUGH sum
    | FROM sum TO sum
    | CIRCLE CENTRE sum
    | RADIUS expression
impact_properties: impact_property (COMMA impact_property)*
impact_property: LETTER EQUAL expression
    | ALONG expression
    | OFFSET expression

?relation: expression (_relator expression)+ -> compare
    | expression ALIGN expression -> aligned
    | NAME AT_REST -> at_rest
    | NAME AND NAME COLLIDE_AGAIN -> collide_again
    | NAME HITS NAME AGAIN -> hits_again
    | NAME DOES_NOT_HIT NAME AGAIN -> hits_again
    | NAME WILL_HIT NAME -> will_hit
_relator: EQUAL | ORDER

?item: expression -> value
    | expression PERCENTAGE -> value
    | RANGE_OF expression -> range
    | RANGE_OF expression PERCENTAGE -> range
    | EXTREME_OF expression OVER expression -> extremum
    | EXTREME_OF expression OVER expression PERCENTAGE -> extremum
"""
)
