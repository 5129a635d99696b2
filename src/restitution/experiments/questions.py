"""What a worksheet of the experiment says and asks; formulas stand in braces by name."""

from __future__ import annotations

from restitution.records import dataclass

AIM = (
    "To find the coefficient of restitution {e} between a ball and a wall from angles, to say how "
    "well it is known, and to check the law {law}."
)
SITUATION = (
    "Path of the centre of the ball, from above. {alpha} and {beta} are the angles to the wall, "
    "before and after the impact; {u} and {v} are the speeds. The dashed line is parallel to the "
    "wall, one radius from it."
)
APPARATUS = (
    "A hard ball, or a puck; a smooth level table; a straight heavy wall that does not move, such "
    "as a board clamped to the table; a ramp; a large sheet of paper; ruler, pencil, protractor. "
    "Or a camera that looks straight down, in place of the paper."
)
METHOD = (
    (
        "Lay the paper against the wall. Draw a line parallel to the wall, at the distance of one"
        " radius of the ball: the centre turns back on this line."
    ),
    (
        "Let the ball roll from the same height of the ramp each time, so that its speed is "
        "always the same."
    ),
    (
        "Turn the ramp so that the ball comes at the first angle {alpha} of the table. Mark two "
        "points of the path before the impact and two after it, as far apart as you can."
    ),
    (
        "Draw both straight lines. Measure {alpha} and {beta} from the line along the wall, not "
        "from the normal. Write down what you read, to half a degree if you can: it need not be "
        "the angle that you aimed at."
    ),
    (
        "Go on with the other angles. Several are needed: with one alone, nothing shows whether "
        "the law holds."
    ),
    (
        "Measure one of the angles five times anew, drawing and all. The spread of the five tells"
        " the error of a reading."
    ),
)
DOTS = "........"
REPEATED = (
    f"Five readings of one angle: {DOTS}    {DOTS}    {DOTS}    {DOTS}    {DOTS}      "
    f"Error of a reading: ± {DOTS} °"
)
COMMAND = (
    "Readings typed into a file angles.csv, with alpha,beta in its first line, are fitted and "
    "checked by: restitution experiment angles.csv --angle-error 1 -o report.pdf"
)


@dataclass(frozen=True)
class Question:
    """What is asked, the room for its answer in millimetres, and the answer."""

    words: str
    room: float
    answer: str


QUESTIONS = (
    Question(
        "The wall is smooth. Write down what happens to the component of velocity along the wall, "
        "and to the component at right angles to it. Show that {law}.",
        24,
        "The impulse has no part along the wall, so {along}. By Newton's experimental law "
        "{across}. The second divided by the first is {law}.",
    ),
    Question(
        "Work out {ratio} for each trial, and the mean. This is a first value of {e}.",
        14,
        "Each row gives {e_of_angles}. The mean lets every row count the same, though not all are "
        "known equally well.",
    ),
    Question(
        "Plot {tan_beta} against {tan_alpha}. Draw by eye the straight line through the origin "
        "that fits best, and find its slope. Which quantity is the slope?",
        14,
        "The slope is {e}. It is read from two points of the line that are far apart, not from "
        "two readings. The eye follows the points far out, which are the steep impacts.",
    ),
    Question(
        "Draw the steepest and the flattest line through the origin that still fit. What do they "
        "say about how well {e} is known?",
        14,
        "Half the difference of their slopes is a fair uncertainty of {e}. With errors of 1° and "
        "the angles of the table it is some hundredths.",
    ),
    Question(
        "An angle is read to ±1°. Work out tan 44° and tan 46°, then tan 79° and tan 81°. By how "
        "much is the tangent uncertain at 45°, and at 80°? Why do steep impacts count less?",
        20,
        "tan 44° = 0.966 and tan 46° = 1.036: ±0.035, or 3.5%. tan 79° = 5.14 and tan 81° = 6.31: "
        "±0.6, or 10%. A point far out is known badly, so it should count less, though it pulls "
        "hardest on a line that is drawn by eye.",
    ),
    Question(
        "A student measures both angles from the normal of the wall instead, and works out "
        "{ratio} with them. What does she get?",
        16,
        "Her angles are 90° − {alpha} and 90° − {beta}, and their tangents are one over those "
        "wanted. So she gets one over {e}, which is above 1.",
    ),
    Question(
        "What would a value of {e} above 1 mean? What would you look for, if it came out so?",
        16,
        "The ball would leave with more kinetic energy than it brought, as the component at right "
        "angles to the wall would grow. No impact of this kind does that. Look for columns that "
        "are exchanged, for angles from the normal, and for a wall that moves.",
    ),
    Question(
        "The points lie on a line that misses the origin. What may be the cause?",
        16,
        "The line from which angles are measured is turned against the wall: then all {alpha} are "
        "read too large and all {beta} too small, or the other way round.",
    ),
    Question(
        "Ten trials at one angle, or ten at different angles: which tells {e} better, and which "
        "tells more about the law?",
        16,
        "Ten at one good angle tell {e} a little better. But any law fits them: only different "
        "angles show whether {law} holds.",
    ),
    Question(
        "The wall is rough. What changes, and is {ratio} still equal to {e}?",
        16,
        "Friction makes the component along the wall smaller, so {beta} is larger than at a "
        "smooth wall, and {ratio} is larger than {e}. Angles alone do not show this; it takes "
        "speeds as well.",
    ),
    Question(
        "Choose an angle {alpha} that you have not tried. Predict {beta} with your value of {e}, "
        "then measure it. Is the difference larger than the errors explain?",
        18,
        "The errors of both angles are in the difference, and that of {e}. Up to twice the error "
        "of a reading is nothing strange.",
    ),
)
