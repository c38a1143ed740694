"""The kind of mistake that a threshold is, by its law and the statement's bands."""

from __future__ import annotations

from collections.abc import Sequence

from judge.run.thresholds import Law, Threshold

NONE, ABSOLUTE, MIXED = "no-epsilon", "absolute-epsilon", "mixed-epsilon"
LOOSE, TIGHT = "loose-epsilon", "tight-epsilon"
_CLOSE = 1.3  # how exactly a factor is known
_NAMED = "{}-epsilon"  # one that follows a size of another name


def epsilon_mistake(law: Law, size: str, within: float, beyond: float) -> str | None:
    """The name of the mistake, None where the law is as it should be or where no name says what it is.

    A threshold should be between `within` and `beyond` of the figure's `size`; where both are 0, there should
    be none.

        no-epsilon        there is none, though within a band the decision must not turn
        absolute-epsilon  it does not grow as the figure does: a constant has part in it
        mixed-epsilon     a length is compared with what is none, such as a square
        loose-epsilon     it follows the size, but is wider than `beyond`
        tight-epsilon     it follows the size, but is narrower than `within`
        <size>-epsilon    it follows another length
    """
    if not law.factor and not law.constant:
        return NONE if within else None
    powers = law.powers.values()
    if law.constant or max(powers, default=0) <= 0:
        return ABSOLUTE
    if sum(powers) != 1:
        return MIXED
    if law.powers == {size: 1}:
        if law.factor > beyond * _CLOSE:
            return LOOSE
        return TIGHT if law.factor * _CLOSE < within else None
    (name, *others) = law.powers
    return None if others else _NAMED.format(name.split()[0])


def epsilon_family(thresholds: Sequence[Threshold]) -> str | None:
    """The one mistake that a submission's thresholds make, at whichever borders; None for none or several."""
    made = {each.mistake for each in thresholds if each.mistake is not None}
    return made.pop() if len(made) == 1 else None
