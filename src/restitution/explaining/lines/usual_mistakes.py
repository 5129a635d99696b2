"""What goes wrong, in a few words each: the one wording of every mistake behind a principle.

A mistake with the id of a misconception is that misconception; the others alter no law that could
be run, and are known by their words alone. ``USUAL_MISTAKES`` tells which belong to a topic of the
sentences.
"""

from __future__ import annotations

from collections.abc import Mapping

PHRASES: Mapping[str, str] = {
    # --- misconceptions ---------------------------------------------------------------------------
    "deflection-is-after": "giving the angle after the impact alone",
    "deflection-difference": "putting the angles before and after together in the wrong way",
    "restitution-parallel": "e applied to the component that does not change",
    "restitution-whole-speed": "e applied to whole speeds",
    "restitution-inverted": "e put on the side of the separation",
    "restitution-omitted": "e left out",
    "momentum-sign": "a plus sign for a sphere that moves against the positive sense",
    "restitution-sign": "a wrong sign for a component against the positive sense",
    "impulse-sign": "the sizes subtracted, as the sign of a reversed component is lost",
    "speed-for-component": "whole speeds in place of components",
    "sine-cosine": "sine and cosine exchanged",
    "angle-from-normal": "an angle measured from the wrong line",
    "across-exchanged": "letting the spheres exchange these components",
    "across-changed": "changing the component that stays",
    "mass-omitted": "a mass left out",
    "masses-exchanged": "the masses exchanged",
    "energy-of-difference": (
        "½m(v − u)², the square of a difference in place of the difference of squares"
    ),
    "energy-one-sphere": "counting one sphere alone",
    "energy-fraction-of-line": "a fraction of the energy along one line in place of all of it",
    "energy-component-missing": "one component left out",
    "energy-ratio-as-speed": "taking the ratio of energies for that of speeds",
    "energy-conserved": "taking kinetic energy as conserved",
    "energy-no-half": "leaving out the half",
    "square-not-taken": "a square left out",
    "impulse-of-speeds": "mass × (difference of the speeds)",
    "second-wall-angle": "the angle of the first wall used again at a second one",
    "rounding-early": "rounding before the end",
    # --- others -----------------------------------------------------------------------------------
    "vector-not-unit": "a scalar product with a vector that was not divided by its size",
    "one-radius": "one radius in place of two",
    "wrong-side": "the wrong side",
    "angle-with-circle": "taking the angles with the wall",
    "all-equal": "taking all three as equal",
    "chord-two-angles": "the angle taken with the tangent at one end and the radius at the other",
    "speed-of-before": "the speed before the impact for what comes after it",
    "velocity-for-change": "taking the direction of a velocity instead of that of the change",
    "change-along-wall": "taking the change to be parallel to the wall",
    "moves-as-the-other": "sending it off in the direction in which the other sphere came",
    "share-across": "giving it a share of the other sphere's velocity across the line",
    "speed-with-component": (
        "the whole speed with a distance that is measured in the direction of one component"
    ),
    "one-side-only": "giving one of the two answers only",
    "sizes-for-vectors": "adding sizes in place of vectors",
    "speeds-subtracted": "subtracting speeds where the velocities have different directions",
    "time-from-start": "counting the time from the start in place of the impact",
    "square-of-sum": "the square of a sum in place of the sum of squares",
    "quotient-inverted": "the quotient upside down",
    "components-added": "adding the components themselves",
    "sign-of-reversed": "the sign lost of a component that is reversed",
    "along-times-across": "the product of a component along with one across",
    "parallel-as-equal": (
        "setting the components equal, which holds only if the sizes are equal too"
    ),
    "product-as-vector": "giving a vector for it",
    "size-left-out": "one size left out",
    "acute-for-obtuse": "an acute angle where the scalar product is negative",
    "moved-for-place": "giving how far the body has moved in place of where it is",
    "same-sign": "giving both impulses the same sign",
    "unequal-impulses": "making them unequal because the masses are",
}

_OF_TOPICS: Mapping[str, tuple[str, ...]] = {
    "restitution": (
        "restitution-whole-speed",
        "restitution-parallel",
        "restitution-inverted",
    ),
    "momentum": ("speed-for-component", "mass-omitted", "masses-exchanged", "momentum-sign"),
    "unchanged-wall": ("restitution-parallel", "across-changed", "sine-cosine"),
    "unchanged": ("across-exchanged", "across-changed"),
    "impulse-wall": ("impulse-sign", "impulse-of-speeds"),
    "impulse-spheres": ("impulse-sign", "impulse-of-speeds"),
    "impulse": ("impulse-of-speeds",),
    "resolved-spheres": ("sine-cosine", "angle-from-normal", "vector-not-unit"),
    "resolved-wall": ("angle-from-normal", "second-wall-angle"),
    "offset": ("one-radius", "sine-cosine"),
    "round": ("angle-with-circle", "all-equal"),
    "chord": ("chord-two-angles", "speed-of-before"),
    "impulse-line": ("velocity-for-change",),
    "impulse-along": ("vector-not-unit",),
    "impulse-away": ("vector-not-unit",),
    "impulse-normal": ("change-along-wall",),
    "moves-off": ("moves-as-the-other",),
    "loss-spheres": (
        "energy-one-sphere",
        "energy-of-difference",
        "energy-conserved",
        "energy-fraction-of-line",
    ),
    "loss-wall": ("energy-of-difference", "energy-component-missing", "energy-fraction-of-line"),
    "turned-wall": ("deflection-is-after", "deflection-difference"),
    "turned": ("deflection-is-after", "deflection-difference"),
    "flight": ("speed-with-component",),
    "turned-velocity": ("one-side-only", "speed-of-before"),
    "either-side": ("one-side-only",),
    "moves-along": ("share-across",),
    "beside": ("one-radius", "wrong-side"),
    "momentum-of": ("sizes-for-vectors",),
    "distance": ("speeds-subtracted", "time-from-start"),
    "change-of-energy": ("energy-of-difference",),
    "energy-ratio": ("energy-ratio-as-speed", "energy-component-missing"),
    "derived-energy": (
        "energy-component-missing",
        "energy-no-half",
        "energy-ratio-as-speed",
        "square-of-sum",
    ),
    "derived-direction": ("quotient-inverted", "angle-from-normal"),
    "derived-speed": ("components-added", "energy-component-missing", "square-not-taken"),
    "derived-size": ("components-added", "square-not-taken"),
    "derived-perpendicular": ("sign-of-reversed", "along-times-across"),
    "derived-parallel": ("parallel-as-equal",),
    "derived-product": ("product-as-vector", "along-times-across"),
    "derived-between": ("size-left-out", "acute-for-obtuse"),
    "derived-place": ("moved-for-place",),
    "relative-velocity": ("sign-of-reversed",),
    "derived-assembled": ("energy-component-missing", "sign-of-reversed"),
    "changed-spheres": ("vector-not-unit", "sign-of-reversed"),
    "changed-wall": ("vector-not-unit", "sign-of-reversed"),
    "derived-opposite": ("same-sign", "unequal-impulses"),
}


def _sentence(mistakes: tuple[str, ...]) -> str:
    beginning = "Usual mistake" if len(mistakes) == 1 else "Usual mistakes"
    return f"{beginning}: {'; '.join(PHRASES[mistake] for mistake in mistakes)}."


USUAL_MISTAKES: Mapping[str, str] = {
    f"{topic}.mistakes": _sentence(mistakes) for topic, mistakes in _OF_TOPICS.items()
}
"""The sentence on usual mistakes of each topic, by its id."""
