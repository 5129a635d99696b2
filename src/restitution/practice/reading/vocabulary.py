"""The words of students' working: which of them announce, part relations, or name quantities."""

from __future__ import annotations

from collections.abc import Mapping

# What stands for *dot product* where velocities are at right angles; nobody types it.
SCALAR_PRODUCT_WORD = "scalarproduct"

HEADS: Mapping[str, str] = {
    **dict.fromkeys(("speed", "speeds", "spd"), "speed"),
    **dict.fromkeys(("velocity", "velocities", "vel", "velo", "vels"), "velocity"),
    **dict.fromkeys(("component", "components", "comp", "comps", "cpt", "cmpt"), "component"),
    **dict.fromkeys(("ke", "kinetic", "energy", "energies", "k.e", "ek"), "energy"),
    **dict.fromkeys(("impulse", "impulses", "imp"), "impulse"),
    **dict.fromkeys(("magnitude", "mag", "size", "modulus"), "magnitude"),
    **dict.fromkeys(("deflection", "deflected", "deflections", "defl", "turned"), "deflection"),
    **dict.fromkeys(("angle", "angles", "ang"), "angle"),
    **dict.fromkeys(("ratio", "fraction", "frac", "proportion", "percentage", "percent"), "ratio"),
    **dict.fromkeys(("momentum", "momenta", "mom", "mtm"), "momentum"),
    **dict.fromkeys(("approach", "app", "appr", "approaching", "closing"), "approach"),
    **dict.fromkeys(("separation", "sep", "separating", "seperation"), "separation"),
    **dict.fromkeys(("loss", "lost", "losses"), "loss"),
    **dict.fromkeys(("gain", "gained"), "gain"),
    "change": "change",
    "mass": "mass",
    "masses": "mass",
    "coefficient": "coefficient",
    "restitution": "coefficient",
    "direction": "direction",
    **dict.fromkeys(("gradient", "slope", "grad"), "gradient"),
    "distance": "distance",
    "dist": "distance",
    "gap": "distance",
    "time": "time",
    **dict.fromkeys(("position", "posn", "coordinates", "coords"), "position"),
    SCALAR_PRODUCT_WORD: "scalar product",
}

DIRECTIONS: Mapping[str, str] = {
    **dict.fromkeys(
        ("perp", "perpendicular", "perpendicularly", "prp", "normal", "perpendic"), "perpendicular"
    ),
    **dict.fromkeys(
        ("parallel", "par", "para", "paral", "tangential", "tangent", "parallell", "paralell"),
        "parallel",
    ),
    **dict.fromkeys(("along", "alng"), "along"),
    "across": "perpendicular",
    **dict.fromkeys(("horizontal", "horizontally", "horiz", "hor", "horizontals"), "horizontal"),
    **dict.fromkeys(("vertical", "vertically", "vert"), "vertical"),
    **dict.fromkeys(("loc", "centres", "centers", "centre", "center"), "centres"),
    "left": "left",
    "leftwards": "left",
    "right": "right",
    "rightwards": "right",
    "up": "up",
    "upwards": "up",
    "down": "down",
    "downwards": "down",
    "towards": "towards",
    "toward": "towards",
    "away": "away",
    "opposite": "opposite",
}

STAGES: Mapping[str, str] = {
    **dict.fromkeys(("before", "initial", "initially", "original", "originally", "bef"), "before"),
    **dict.fromkeys(
        ("after", "final", "afterwards", "finally", "new", "afterward", "rebound", "aft"), "after"
    ),
    "start": "before",
    "end": "after",
}

AT_THE_START = frozenset(
    ("start", "initial", "initially", "original", "originally")
)  # before all events as well as before the last

ORDINALS: Mapping[str, int] = {
    "first": 1,
    "second": 2,
    "third": 3,
    "fourth": 4,
    "1st": 1,
    "2nd": 2,
    "3rd": 3,
    "4th": 4,
    "one": 1,
    "two": 2,
    "three": 3,
}

EVENT_WORDS = frozenset(
    ("impact", "impacts", "collision", "collisions", "hit", "hits", "bounce", "collide", "strikes")
    + (
        "collides",
        "collison",
        "strike",
        "hitting",
        "colliding",
        "blow",
        "kick",
        "coll",
        "contact",
        "rebounds",
    )
)
BODY_WORDS = frozenset(
    ("sphere", "spheres", "ball", "balls", "particle", "particles", "body", "wall", "walls")
    + ("cushion", "disc", "puck", "snooker", "both", "barrier", "side")
)
# Short forms with a point behind them: ``sep. speed``, ``rel. vel. before``.
ABBREVIATED = frozenset(
    ("sep", "app", "appr", "rel", "vel", "perp", "par", "para", "comp", "cpt", "horiz", "vert")
    + ("mom", "imp", "mag", "defl", "ang", "dist", "coeff", "bef", "aft", "spd", "prp")
)
# Words that may stand within a phrase and add nothing to it.
FILLERS = frozenset(
    ("of", "the", "in", "to", "from", "for", "on", "with", "its", "by", "between", "at", "and")
    + ("just", "immediately", "line", "direction", "total", "overall", "system", "whole", "plane")
    + ("travelled", "traveled", "moved", "covered", "apart")
    + ("surface", "moment", "makes", "made", "relative", "combined", "through", "s", "axis", "dir")
    + ("dirn", "moves", "moving", "actual", "resultant", "sum", "which", "it", "that", "their")
    + ("motion", "given", "exerted", "received", "common", "full", "into", "wrt", "joining", "rel")
    + ("reduced", "path", "paths", "trajectory", "back")
)
PHRASE_WORDS = (
    frozenset(HEADS)
    | frozenset(DIRECTIONS)
    | frozenset(STAGES)
    | frozenset(ORDINALS)
    | EVENT_WORDS
    | BODY_WORDS
    | FILLERS
)

# Words that end one statement and begin another.
CONNECTIVES = frozenset(
    ("so", "hence", "therefore", "thus", "then", "and", "giving", "gives", "give", "ie", "also")
    + ("because", "since", "as", "but", "implies", "means", "now", "get", "with", "using", "when")
    + ("if", "sub", "subbing", "substitute", "substituting", "into", "from", "next", "similarly")
    + ("whereas", "while", "hense", "there4", "cos_of", "which", "that", "yields", "leads", "eg")
)
DECLARES = frozenset(
    ("let", "take", "set", "suppose", "assume", "denote", "call", "define", "say", "lets", "taking")
    + ("letting",)
)
EQUALS = frozenset(("is", "equals", "equal", "are", "was", "be", "becomes", "eq"))
SPOKEN = {"plus": "+", "minus": "-", "times": "*", "over": "/"}
# After these the next item belongs to the prose: "divide by m", "from 1".
SWALLOWING = frozenset(
    ("by", "from", "into", "in", "eq", "equation", "equations", "eqn", "eqns", "line", "through")
    + ("out", "cancel", "cancelling", "step", "use", "using", "law")
)

ANNOUNCING = frozenset(
    ("clm", "colm", "pclm", "nel", "nlr", "nli", "nell", "com", "cons", "conservation", "newton")
    + ("newtons", "newton's", "experimental", "law", "momentum", "restitution", "mom", "linear")
    + ("impulse", "resolve", "resolving", "answer", "ans", "final", "solve", "solving", "add")
    + ("adding", "subtract", "subtracting", "simultaneously", "simultaneous", "eqn", "eqns")
    + ("equation", "equations", "divide", "dividing", "multiply", "multiplying", "square")
    + ("squaring", "rearrange", "rearranging", "simplify", "simplifying", "pythag", "pythagoras")
    + ("lhs", "rhs", "qed", "shown", "required", "proved", "result", "check", "note", "find")
    + ("finding", "work", "working", "diagram", "sub", "con", "principle")
)

# Plain English that is never a product of letters.
_ENGLISH = """
a about above accept across actually acute add adj after again against all along already also
always am an and angle angles another answer anticlockwise any apply are as asked assume
assuming at away back ball balls based be because become becomes been before being below between
beyond big bigger bit both bounce bounces but by calculate calculator can cancel cannot cant
case cases cause change changes check choose clearly clockwise coefficients collide collision
collisions combine combined common compare comparing conserved consider considering constant
correct could data deduce deflected deflection degrees denominator diagram did didnt different
direction directions divide divided do does doesnt doing done dont dot double down drop each eg
either elastic eliminate energy enough equal equals equating equation equations etc even every
exact exactly expand experimental expression fact faster final finally find first follows for
form formula found fraction from further general get gets getting give given gives giving goes
going good got gradient gradients greater greatest group had half hang hard has have he help
hence her here him his hit hits hmm hold holds hoping horizontally how however hyp hypot
hypotenuse i identity idk ie if ignore immediately impact implies impossible in inelastic
initial initially inside instead into invalid inverse is isnt it its itself joule joules just
keep kg know known larger last later law leads least leaves left less let lets like line lines
lol look lost made magnitude make makes mass masses max maximum may maybe me mean means method
metres min minimum minus more most motion move moved moves moving multiply must my name nb need
needed needs negative never new newton newtons next no none nope normal not note nothing now
number obtain obtuse of off ok okay on once one only onto opp opposite or original other others
otherwise our out outside over own parallel part particle particles particular per perfectly
perhaps perpendicular plus point positive possible principle product proof prove proved put
pythag pythagoras qed quadratic quarter question range ratio reached rearrange reflex reject
rejected remains required resolve resolved respectively rest result resultant reverse reversed
reverses right root roots rounded rule same say says scalar scrap second seconds see seen
separate set she should show shown sides sign simplify simultaneous since sixth size small
smaller smallest smooth so solve solving some sorry speed sphere spheres square squared squaring
start stationary stays still straight sub subbing substitute subtract such sum surface take
taken takes taking tells than that thats the their them then there therefore these they thing
think third this those three through thus time times to together too total towards travels
triangle trig true try turn turned twice two type um unchanged under unit units unknown until up
us use used uses using valid value values vec vecs vect vector vectors velocity versa vertical
vertically very via vice wait want was way ways we well were what when where which while whilst
whole why will with within without wont work works would write wrong yep yes you zero
"""
PROSE = frozenset(_ENGLISH.split())

# Letters as well as words: what stands beside them decides.
SHORT = frozenset(("a", "i", "an", "we", "me", "us", "am", "my", "he", "s", "be", "um", "k"))

FUNCTION_NAMES: Mapping[str, str] = {
    **{ratio: ratio for ratio in ("sin", "cos", "tan", "cot", "sec", "cosec", "sqrt", "abs")},
    **{ratio: ratio for ratio in ("arcsin", "arccos", "arctan")},
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "invsin": "arcsin",
    "invcos": "arccos",
    "invtan": "arctan",
    "arcsine": "arcsin",
    "arccosine": "arccos",
    "arctangent": "arctan",
    "csc": "cosec",
    "root": "sqrt",
    "rt": "sqrt",
    "mod": "abs",
    "sine": "sin",
    "cosine": "cos",
    "tangent": "tan",
}
INVERSES = {"sin": "arcsin", "cos": "arccos", "tan": "arctan"}
