"""Claims that are shown or refuted."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "claim.perpendicular": "{left} is perpendicular to {right}",
    "claim.parallel": "{left} is parallel to {right}",
    "claim.same-direction": "{left} is in the direction of {right}",
    "claim.as": "{claim}, since {reason}",
    "claim.unless-at-rest": "{claim} unless {body} is at rest",
    "claim.opposite": "{left} is opposite to {right}",
    "claim.not-perpendicular": "{left} is not perpendicular to {right}",
    "claim.not-parallel": "{left} is not parallel to {right}",
    "claim.not-same-direction": "{left} is not in the direction of {right}",
    "claim.not-opposite": "{left} is not opposite to {right}",
    "claim.rest": "{body} is at rest",
    "claim.collide": "{one} and {other} collide{again}",
    "claim.hits": "{body} hits {wall}{again}",
    "claim.does-not-hit": "{body} does not hit {wall}{again}",
    "claim.not-collide": "{one} and {other} do not collide{again}",
    "claim.will-collide": "{one} and {other} will collide{again}",
    "claim.will-not-collide": "{one} and {other} will not collide{again}",
    "claim.will-hit": "{body} will hit {wall}{again}",
    "claim.will-not-hit": "{body} will not hit {wall}{again}",
    "claim.gap-closes": "the gap between {one} and {other} closes",
    "claim.gap-does-not-close": "the gap between {one} and {other} does not close",
    "refuted.rest": "{body} is not at rest: {velocity}.",
    "refuted.direction": "{claim}.",
    "refuted.no-multiple": "{claim}, as {left} is not a multiple of {right}.",
    "refuted.direction-as": "{claim}, as {relation}.",
    "refuted.direction-instance": (
        "{claim} in general: with {values:and}, for instance, {sides:and}."
    ),
    "refuted.bearing-instance": (
        "{claim} in general: with {values:and}, for instance, {sides:and}, {bearing}."
    ),
    "refuted.same-direction": "which are in the same direction",
    "refuted.opposite-direction": "which are in opposite directions",
    "refuted.no-multiple-of": "and neither is a multiple of the other",
    "refuted.in-direction-of-one": "which is in the direction of {other}",
    "refuted.opposite-to-one": "which is opposite to {other}",
    "refuted.no-multiple-of-one": "which is not a multiple of {other}",
    "refuted.product-instance": (
        "{claim} in general: with {values:and}, for instance, {sides:and}, so {product}."
    ),
    "refuted.opposite": "So {claim}, and the claim is not true.",
    "refuted.opposite-above": "It is not true that {claim}, as shown above.",
    "refuted.plainly": "It is not true that {claim}.",
    "refuted.extreme": "The {quantity} is not {claimed}.",
    "refuted.range-is": "The range of possible values is not {range}: it is {true}.",
    "refuted.range": "The range of possible values is not {range}.",
    "refuted.value": "The {quantity} is not {claimed}: it is {value}.",
    "refuted.value-differs": ("The {quantity} is not {claimed}: it is {value}, and {difference}."),
    "refuted.as": "{relation}, as {reasons:and}",
    "refuted.vector-differs": "{quantity} is not {claimed}: it is {value}, and {difference}.",
    "refuted.value-general": "The {quantity} is not {claimed} in general: it is {value}.",
    "refuted.vector": "{quantity} is not {claimed}: it is {value}.",
    "refuted.vector-general": "{quantity} is not {claimed} in general: it is {value}.",
    "refuted.claim": "It is not true that {claim}: {sides}.",
    "refuted.general": ("It is not true that {claim}: with {values:and}, for instance, {sides}."),
    "refuted.possible": "It is not true that {claim}: {letter} may be {value}.",
    "refuted.possible-with": (
        "It is not true that {claim}: {letter} may be {value}, with {values:and}."
    ),
    "refuted.possible-when": (
        "It is not true that {claim}: {letter} is {value}, for instance, when {values:and}."
    ),
    "refuted.sides": "{sides:and}",
    "refuted.by-ratio": "{ratio}, so {side}",
    "refuted.but": "{one}, but {other}",
    "refuted.less": "{sides:and}, which is less",
    "refuted.more": "{sides:and}, which is more",
    "refuted.equal": "{sides:and}, which is the same",
    "refuted.less-than": "{side}, which is less than {bound}",
    "refuted.more-than": "{side}, which is more than {bound}",
    "refuted.not-less-than": "{side}, which is not less than {bound}",
    "refuted.not-more-than": "{side}, which is not more than {bound}",
    "refuted.not-equal-to": "{side}, which is not {bound}",
    "refuted.so": "{sides:and}, so {claim}",
    "refuted.instance": ("It is not true that {claim}: it fails, for instance, with {values:and}."),
    "undecided.claim": (
        "It is not decided whether {claim}. It fails at none of the values of the letters that "
        "were tried, but that proves nothing."
    ),
}
