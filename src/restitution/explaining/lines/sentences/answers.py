"""Ranges, extrema, values to be shown, answers and their notes."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "range.every": "So every value of {letter} is possible:",
    "range.every-free": "No condition bounds {letter}, so every value of it is possible:",
    "range.every-holds": "This always holds, so every value of {letter} is possible:",
    "range.every-given": (
        "So it always holds that {facts:and}, as is given, and every value of {letter} is possible:"
    ),
    "range.every-holds-as": (
        "This always holds, as {bounds:and}, so every value of {letter} is possible:"
    ),
    "range.also": "In this range {bounds:and} as well.",
    "range.also-as": "In this range {bounds:and} as well, as {reasons:and}.",
    "range.both": "{one} {two}",
    "range.within": "In this range {bounds:and}, so {body} hits {walls:and} between its ends too.",
    "range.within-anyway": "{body} hits {walls:and} between its ends too, as {bounds:and}.",
    "range.within-before": "{body} hits {walls:and} between its ends, as {bounds:and}.",
    "range.within-all-before": "{body} hits {walls:and} between their ends, as {bounds:and}.",
    "range.within-all-anyway": "{body} hits {walls:and} between their ends too, as {bounds:and}.",
    "range.within-all": (
        "In this range {bounds:and}, so {body} hits {walls:and} between their ends too."
    ),
    "extremum.value": "When {places:or}, {value}. The difference from that value is",
    "extremum.value-there": "When {places:or}, {value}.",
    "extremum.at-zero": "{square}, so {place}",
    "extremum.at-zero-angle": "{square}, so {place} and {angle}",
    "extremum.at-zero-sine": "{square}, so {tangent}, {sine} and {offset}",
    "extremum.by-sine": "{place}, so {offset}",
    "extremum.at-angle": "{place}, so {angle}",
    "extremum.with": "{place} and so {other}",
    "extremum.approached": "as {place}: a bound that is approached and not reached",
    "extremum.no-greatest": "as {place}, so there is no greatest value",
    "extremum.no-least": "as {place}, so there is no least value",
    "extremum.no-greatest-there": "as {place}, but {bound}, so there is no greatest value",
    "extremum.no-least-there": "as {place}, but {bound}, so there is no least value",
    "shown.required": "as required",
    "shown.figures": "to {figures} s.f.",
    "shown.claim": "So {claim}, as required.",
    "note.none-of-two": (
        "{items:capital} cannot be found, as {reason}. That {fact} is one equation for two "
        "unknowns."
    ),
    "note.none": "{items:capital} cannot be found, as {reason}.",
    "note.unsolved": "There is no working of {items}: {reason}.",
    "note.idle": (
        "It is given that {fact}. That is so for all values of {items}, so {items} cannot be found."
    ),
    "note.impossible": "What is described cannot happen, as {reason}.",
    "note.unbounded": "There is no {extreme}: {reason}.",
    "note.out-of-range": "But {reasons:and}. So what is described cannot happen.",
    "note.beyond-there": (
        "From part ({label}), {relation}. But {reasons:and}. So what is described cannot happen."
    ),
    "note.no-root": "This cannot be, as {reasons:and}. So what is described cannot happen.",
    "note.unreached": "So {reason}: what is described cannot happen.",
    "note.on-its-side": "{body} is on the side of {wall} to which {way} points. {then}",
    "note.unreached-as": "As {value}, {reason}: what is described cannot happen.",
    "note.unreached-ahead": (
        "{one} moves in the direction of {way} and hits {other}, so {other} is ahead of it. So "
        "{reason}: what is described cannot happen."
    ),
    "note.no-solution": "This has no solution. So what is described cannot happen.",
    "note.impossible-above": "What is described cannot happen, as shown above.",
    "note.impossible-there": "What is described cannot happen, as part ({label}) shows.",
    "note.clash": "{reason:capital}.",
    "note.against": "But it is given that {fact}. So the data contradict each other.",
    "note.against-zero": (
        "{value} is not zero, as {reasons:and}. But it is given that {fact}. So the data "
        "contradict each other."
    ),
    "note.against-sense": (
        "{value} is positive, as {reasons:and}. But it is given that {fact}. So the data "
        "contradict each other."
    ),
    "note.against-opposite": (
        "{value} is negative, as {reasons:and}. But it is given that {fact}. So the data "
        "contradict each other."
    ),
    "note.unwritten": "{item:capital} is {answer}. The working of this is not written out.",
    "note.unwritten-line": "The working of this is not written out:",
    "note.unwritten-line-from": "The steps from here are not written out:",
    "note.unwritten-from": "{item:capital} is {answer}. The steps from here are not written out.",
    "note.unwritten-cases": "The working of this is not written out. {item:capital} is:",
    "note.unwritten-cases-from": "The steps from here are not written out. {item:capital} is:",
    "note.none-shown": "It cannot be shown that {items}, as {reason}.",
    "note.none-of-it": "No value of {letter} is possible, as shown above.",
    "note.none-shown-either": ("That {items} cannot be shown either, as there is no such impact."),
    "note.none-value": "{items:capital} cannot be found, as no value of {letter} is possible.",
    "note.none-without": (
        "{items:capital} cannot be found without {letter}, of which no value is possible."
    ),
    "note.none-lost": (
        "There is no value of {items}: with {letter} > 1 kinetic energy would be gained, which is "
        "impossible too."
    ),
    "note.none-either": "{items:capital} cannot be found either, as there is no such impact.",
    "note.none-data-above-one": (
        "{items:capital} cannot be found, as a coefficient of restitution is at most 1, and not "
        "{value}."
    ),
    "note.none-data-below-zero": (
        "{items:capital} cannot be found, as a coefficient of restitution is not negative, and not "
        "{value}."
    ),
    "note.above-one": (
        "{value} is impossible, as a coefficient of restitution is at most 1. So no value of "
        "{letter} is possible: what is given cannot occur."
    ),
    "note.other-answers": "the other answers",
    "note.goes-on": ("Without {letter}, {item} can still be worked out from the data."),
    "note.rests-on": (
        "From the data {item} can be worked out all the same, though there is no such impact."
    ),
    "note.below-zero": (
        "{value} is impossible, as a coefficient of restitution is not negative. So no value of "
        "{letter} is possible: what is given cannot occur."
    ),
    "note.none-above-one": (
        "{items:capital} cannot be found, as {value} is impossible: a coefficient of restitution "
        "is at most 1."
    ),
    "note.none-below-zero": (
        "{items:capital} cannot be found, as {value} is impossible: a coefficient of restitution "
        "is not negative."
    ),
    "no-root.square": "a square is not negative",
    "no-root.unit": "{square} is at most 1",
    "no-root.least": "{ratio} is at least −1",
    "no-root.definite": "the discriminant of {sum} is negative: {discriminant}",
    "no-root.discriminant": "the discriminant of {equation} is negative: {discriminant}",
    "answer.by-case": "This holds for {condition}. In all, the range is {forms:semicolon}.",
    "answer.only": "This holds for {condition} only.",
    "answer.only-at": "This holds for {condition} only: if {end}, {there}.",
    "answer.only-leaving": (
        "This holds for {condition} only: if {end}, {body} does not leave {wall}."
    ),
    "answer.both": "{first} {second}",
    "answer.value-only": "{value} holds for {condition} only.",
    "answer.value-only-as": "As {reasons:and}, {value} holds for {condition} only.",
    "answer.only-range": (
        "This holds for {condition} only, as there is no such {letter} otherwise."
    ),
    "answer.approaching": "{one} has to move towards {two} to hit it",
    "answer.moving": "{body} is still moving at the end",
    "answer.no-value": "{place} gives no value of {letter}",
    "answer.divisor": "the divisor {divisor} is not zero",
    "answer.only-as": "As {reasons:and}, this holds for {condition} only.",
    "answer.reason": "{item}: {reason}",
    "answer.undecided": "{item}: not decided",
    "answer.outcome": "{item}: {outcomes:comma}",
    "answer.shown": "shown",
    "answer.false": "false",
    "answer.value": "{item} = {values:or}",
}
