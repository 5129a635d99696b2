"""The grammar of expressions (LALR). Its terminals come from the scanner in ``lexer``."""

TERMINALS = """
%declare NUMBER DEGREES FRACTION COEFFICIENT PI LETTER UNIT NAME
%declare PLUS MINUS STAR SLASH POW IMPLICIT LPAR RPAR COMMA
%declare FUNCTION FUNCTION_CALL QUANTITY QUANTITY_CALL AT FROM TO BEFORE MEASURE
"""

# ``at`` binds loosest; then sums, a leading sign, products (juxtaposition is IMPLICIT), a function
# without brackets, powers. A quotient is apart from other products only so that ``v^2/2g`` can
# be noticed.
RULES = """
?expression: sum
    | sum AT sum -> polar
    | sum AT sum FROM sum -> polar
    | sum AT sum TO NAME -> polar
?sum: signed
    | sum PLUS signed -> binary
    | sum MINUS signed -> binary
?signed: product
    | MINUS signed -> negate
    | PLUS signed -> positive
?product: factor
    | product SLASH unary -> quotient
    | product STAR unary -> binary
    | product IMPLICIT factor -> implicit
    | product MEASURE -> measured
?unary: factor
    | MINUS unary -> negate
    | PLUS unary -> positive
?factor: power
    | bare
bare: FUNCTION argument
?argument: power
    | bare
    | COEFFICIENT symbol -> multiple
    | COEFFICIENT symbol POW exponent -> multiple
?symbol: LETTER | PI
?power: primary
    | primary POW exponent -> binary
?exponent: factor
    | MINUS exponent -> negate
    | PLUS exponent -> positive
?primary: NUMBER | DEGREES | FRACTION | PI | LETTER | UNIT | NAME | QUANTITY
    | LPAR expression RPAR -> group
    | LPAR expression COMMA expression RPAR -> pair
    | FUNCTION_CALL LPAR expression RPAR -> call
    | QUANTITY_CALL LPAR quantity_argument (COMMA quantity_argument)* RPAR -> quantity
?quantity_argument: expression
    | BEFORE -> before
    | AT sum -> at_time
"""

EXPRESSION = TERMINALS + RULES
"""The grammar of an expression by itself."""
