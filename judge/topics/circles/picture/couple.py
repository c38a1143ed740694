"""Two circles in a picture: where they come closest to a touch, and that in words."""

from __future__ import annotations

from fractions import Fraction

from judge.drawing.frame import ExactNumber
from judge.drawing.lengths import short
from judge.exact import Surd
from judge.topics.circles.pair import CirclePair


def nearest_touch(pair: CirclePair) -> tuple[Surd, bool]:
    """How far the centres' distance is from that of a touch, and whether it is one from outside."""
    outer, inner = (Surd(-reach, 1, pair.square, 1) for reach in pair.reaches)
    outside = abs(outer).compare(abs(inner)) <= 0
    return (outer if outside else inner), outside


def touching_place(pair: CirclePair) -> tuple[ExactNumber, ExactNumber]:
    """The point of circle 1 next to that touch, in the pair's units."""
    _, outside = nearest_touch(pair)
    x, y = pair.on_first(1 if outside or pair.r1 > pair.r2 else -1)
    unit = 1 << pair.shift
    return x * unit, y * unit


def pair_words(pair: CirclePair) -> str:
    """How the circles lie, for a sentence."""
    e = Fraction(pair.extent or 1)
    if not pair.square:
        difference = abs(pair.r1 - pair.r2)
        return (
            f"the radii about one centre differ by {short(difference / e)} e"
            if difference
            else "the circles are the same"
        )
    gap, outside = nearest_touch(pair)
    side = gap.sign()
    if not side:
        return f"the circles touch exactly, {'from outside' if outside else 'one inside the other'}"
    share = short(abs(gap) / e)
    if outside:
        return f"the circles are {share} e apart" if side > 0 else f"the circles cross {share} e deep"
    return (
        f"one circle stands {share} e out of the other"
        if side > 0
        else f"one circle is {share} e inside the other"
    )
