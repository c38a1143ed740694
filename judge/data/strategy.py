"""Every builder as a Hypothesis strategy over its parameters, so that a failing case shrinks by them.

Import this only to search or to shrink: Hypothesis takes longer to import than judging takes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Never

from hypothesis import reject
from hypothesis import strategies as st
from hypothesis.errors import HypothesisException

from judge.data.draw import Draw, Rejected, T
from judge.problem import Case


class HypothesisDraw:
    """Choices that Hypothesis makes: each an integer that shrinks towards 0."""

    __slots__ = ("_draw",)

    def __init__(self, draw: st.DrawFn) -> None:
        self._draw = draw

    def integer(self, low: int, high: int) -> int:
        """The integer from low to high, both included, that Hypothesis likes next."""
        if low > high:
            raise ValueError(f"no integer from {low} to {high}")
        return self._draw(st.integers(low, high))

    def choice(self, options: Sequence[T]) -> T:
        """One of `options`; ValueError if there is none."""
        if not options:
            raise ValueError("nothing to choose from")
        return options[self.integer(0, len(options) - 1)]

    def sign(self) -> int:
        """One, the simpler, or minus one."""
        return -1 if self.integer(0, 1) else 1

    def boolean(self) -> bool:
        """False, the simpler, or True."""
        return bool(self.integer(0, 1))

    def reject(self) -> Never:
        """Give these choices up."""
        raise Rejected


def strategy(builder: Callable[[Draw], Case]) -> st.SearchStrategy[Case]:
    """The cases of a builder whose parameters are filled in; choices that make none are left out."""

    @st.composite
    def cases(draw: st.DrawFn) -> Case:
        try:
            return builder(HypothesisDraw(draw))
        except HypothesisException:
            raise
        except Exception:  # a shrunk choice may break what the recipe counts on, as a divisor that becomes 0
            reject()

    return cases()
