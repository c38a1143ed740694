"""Every builder as a Hypothesis strategy over its parameters, so that a failing case shrinks by them.

Import this only to search or to shrink: Hypothesis takes longer to import than judging takes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from hypothesis import reject
from hypothesis import strategies as st
from hypothesis.errors import HypothesisException
from msgspec import Struct

from judge.data.draw import ChosenDraw, Draw
from judge.problem import Case


class Built(Struct, frozen=True):
    """A case and the choices it was built from."""

    case: Case
    choices: tuple[int, ...]


class HypothesisDraw(ChosenDraw):
    """Choices that Hypothesis makes: each an integer that shrinks towards 0."""

    __slots__ = ("_draw",)

    def __init__(self, draw: st.DrawFn) -> None:
        super().__init__()
        self._draw = draw

    def pick(self, low: int, high: int) -> int:
        """The integer that Hypothesis likes next."""
        return self._draw(st.integers(low, high))


def strategy(builder: Callable[[Draw], Any]) -> st.SearchStrategy[Built]:
    """The cases of a builder whose parameters are filled in; choices that make none are left out."""

    @st.composite
    def cases(draw: st.DrawFn) -> Built:
        source = HypothesisDraw(draw)
        try:
            case = builder(source)
        except HypothesisException:
            raise
        except Exception:  # a shrunk choice may break what the recipe counts on, as a divisor that becomes 0
            reject()
        return Built(case, tuple(source.choices))

    return cases()
