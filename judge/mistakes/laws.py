"""What a submission's thresholds follow, from where its decision turns in figures of different sizes.

A law is constant + factor · size₁^p₁ · size₂^p₂ …, with whole powers. In logarithms every figure bounds the
factor from both sides, and a law holds where these bounds have something in common, but for what differs
between two ways to measure one size: a sum for a maximum, a diagonal for a side.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from math import inf, log10
from typing import NamedTuple

from judge.run.thresholds import Flip, Law

NOISE = 2.0**-49  # of a size: what lies below it is rounding, and no threshold
_LEEWAY = log10(3.0)  # between two ways to measure a size: |x| + |y| is at most 2 max(|x|, |y|)
_BOUNDED = 2  # figures that must bound a law from both sides
_POWERS = (1, 0, -1, -2, 2)
_CLOSE = 0.1  # decades by which two laws hold alike
_MOST = 3  # the sum of a product's powers, without their signs


_Bounds = tuple[float, float]


def law_of(flips: Sequence[Flip]) -> Law | None:
    """The simplest law that holds in every figure; None where none does, or where two are as simple.

    Simple laws, in this order of kind: no threshold at all, one size or a constant, a constant and a size,
    a product of powers.
    """
    bounds = [_bounds(flip) for flip in flips]
    if all(low == -inf for low, _ in bounds):
        return None if any(flip.high is None for flip in flips) else Law({}, 0.0)
    if sum(-inf < low and high < inf for low, high in bounds) < _BOUNDED:
        return None
    names = list(flips[0].sizes)
    for powers in (_single(names), None, _products(names)):
        if powers is None:
            if summed := _sums(names, flips, bounds):
                return summed
        elif held := [found for each in powers if (found := _fitted(each, flips, bounds))]:
            return _simplest(held)
    return None


def _simplest(held: Sequence[_Fit]) -> Law | None:
    """The simplest law, of those the one that holds best; None if another one holds as well.

    Products that hold alike are told apart only by how they grow when all lengths do.
    """
    best, *others = sorted(held, key=lambda each: (each.terms, each.slack))
    alike = [each for each in others if each.terms == best.terms and each.slack <= best.slack + _CLOSE]
    if best.terms > 1:
        alike = [each for each in alike if each.degree != best.degree]
    return None if alike else best.law


def _bounds(flip: Flip) -> _Bounds:
    """The decimal logarithms between which the threshold lies; what is lost in rounding has no lower one."""
    noise = NOISE * flip.size
    low = log10(flip.low) if flip.low > noise else -inf
    return low, inf if flip.high is None else log10(max(flip.high, noise))


def _single(names: Sequence[str]) -> Iterator[Mapping[str, int]]:
    yield from ({name: 1} for name in names)
    yield {}


def _products(names: Sequence[str]) -> Iterator[Mapping[str, int]]:
    for powers in product(_POWERS, repeat=len(names)):
        found = {name: power for name, power in zip(names, powers, strict=True) if power}
        if list(found.values()) not in ([], [1]) and sum(map(abs, powers)) <= _MOST:
            yield found


class _Fit(NamedTuple):
    """A law; how far the figures are from agreeing on its factor, in decades; its powers without signs."""

    law: Law
    slack: float
    terms: int

    @property
    def degree(self) -> int:
        """The power of the scale that it grows with."""
        return sum(self.law.powers.values())


def _fitted(powers: Mapping[str, int], flips: Sequence[Flip], bounds: Sequence[_Bounds]) -> _Fit | None:
    """The law of these powers, if the figures agree on its factor well enough."""
    least, most = -inf, inf
    for flip, (low, high) in zip(flips, bounds, strict=True):
        shift = sum(power * log10(flip.sizes[name]) for name, power in powers.items())
        least, most = max(least, low - shift), min(most, high - shift)
    slack = max(0.0, least - most)
    if slack > _LEEWAY:
        return None
    # A constant is as simple as a size.
    return _Fit(Law(powers, 10 ** ((least + most) / 2)), slack, sum(map(abs, powers.values())) or 1)


def _sums(names: Sequence[str], flips: Sequence[Flip], bounds: Sequence[_Bounds]) -> Law | None:
    """A constant and a size: the constant is all where the size is least, nothing where it is greatest."""
    known = [flip for flip, (low, high) in zip(flips, bounds, strict=True) if -inf < low and high < inf]
    if len(known) <= _BOUNDED:
        return None
    for name in names:
        ordered = sorted(known, key=lambda flip: flip.sizes[name])
        law = Law({name: 1}, ordered[-1].gap / ordered[-1].sizes[name], ordered[0].gap)
        if all(
            low - _LEEWAY <= log10(law.of(flip.sizes)) <= high + _LEEWAY
            for flip, (low, high) in zip(flips, bounds, strict=True)
        ):
            return law
    return None
