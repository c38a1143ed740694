"""A submission's own threshold in words: what it is, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log10

from judge.problem import Verdict
from judge.report.layout import Line, Span, Style, hanging
from judge.run.result import Result
from judge.run.thresholds import Flip, Threshold

_LEAST = 1e-16  # a share of a size below which rounding is all


def threshold_lines(result: Result, width: int | None) -> Iterator[Line]:
    """The threshold that is worth a line, if there is one."""
    if told := result_threshold(result):
        yield from hanging(Span("threshold", Style.FAINT), Span(told), width, indent=2, column=13)


def result_threshold(result: Result) -> str:
    """That threshold in words; empty where there is none."""
    told = worth_telling(result.thresholds, accepted=result.verdict is Verdict.AC)
    return "" if told is None else threshold_text(told)


def worth_telling(thresholds: Sequence[Threshold], *, accepted: bool) -> Threshold | None:
    """The first threshold that is a mistake; of an accepted submission else the first that is right.

    One that is right explains no wrong answer.
    """
    mistaken = next((each for each in thresholds if each.mistake is not None), None)
    if mistaken is not None or not accepted:
        return mistaken
    return next((each for each in thresholds if each.follows_its_size), None)


def threshold_text(told: Threshold) -> str:
    """What it is and what of it: `for …: 1e-9 at size 1, 4e-3 of it at size 2e-7; it does not grow …`."""
    law = told.law
    if not law.factor and not law.constant:
        band = f"{number(told.within)} of the {told.size}"
        return f"for {told.decision}: none, or none that rounding leaves; {band} is no gap yet"
    begin = f"for {told.decision}:"
    if law.constant:
        parts = f"{number(law.constant)} + {_share(told)}"
        return f"{begin} {parts}; " + _unless_none(told, "its first part does not grow with the figure")
    if told.degree == 1 and len(law.powers) == 1:
        return f"{begin} {_share(told)}; {_beside_the_bands(told)}"
    how = "it does not grow with the figure" if not law.powers else "it does not grow as the figure does"
    return f"{begin} {_at_two_sizes(told)}; " + _unless_none(told, how)


def number(value: float) -> str:
    """A number to one digit, as a person would write it: `1e-9`, `0.02`, `300`."""
    if not value:
        return "0"
    rounded = float(f"{value:.0e}")
    if 0.01 <= rounded < 1e4:
        return f"{rounded:g}"
    digit, _, power = f"{rounded:.0e}".partition("e")
    return f"{digit}e{int(power)}"


def _share(told: Threshold) -> str:
    (name,) = told.law.powers
    return f"{number(told.law.factor)} of the {name}"


def _beside_the_bands(told: Threshold) -> str:
    if told.size not in told.law.powers:
        return _unless_none(told, f"it must follow the {told.size}")
    if told.mistake is None:
        return f"that is between {number(told.within)} and {number(told.beyond)}, as it should be"
    wide = told.law.factor > told.beyond
    limit = f"{number(told.beyond)} at most" if wide else f"{number(told.within)} at least"
    return _unless_none(told, f"it must be {limit}")


def _unless_none(told: Threshold, text: str) -> str:
    return text if told.beyond else "there should be none"


def _at_two_sizes(told: Threshold) -> str:
    """The threshold itself in the figure whose size is nearest to 1, and as a share of another one's size."""
    usual = min(told.figures, key=lambda flip: abs(log10(flip.size)))
    others = [
        flip
        for flip in told.figures
        if not 0.5 < flip.size / usual.size < 2 and _LEAST < _relative(told, flip) < 1
    ]
    first = f"{number(told.law.of(usual.sizes))} at size {number(usual.size)}"
    if not others:
        return first
    other = min(others, key=lambda flip: flip.size)
    return f"{first}, {number(_relative(told, other))} of it at size {number(other.size)}"


def _relative(told: Threshold, flip: Flip) -> float:
    return told.law.of(flip.sizes) / flip.size
