"""What passes between the engine and a topic's hooks (`judge.problem.declare.Hooks`).

The engine knows no topic: what it draws or makes simpler as a whole, the hooks draw or make simpler. A
problem without any works in every command. It has no picture.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from judge.problem.model import Problem

if TYPE_CHECKING:
    from judge.drawing import Picture


class Shown(Struct, frozen=True):
    """A case and its answers, to be drawn.

    `values` are the arguments by parameter name, `exact` is what the problem's `solve` answers. `wanted` and
    `got` are the two answers in words; `given` is the submission's own, JSON of any shape whatever, and None
    where there is none. `heading` says which case it is.
    """

    problem: Problem
    values: Mapping[str, Any]
    exact: Any
    wanted: str | None
    got: str | None
    given: Any | None = None
    heading: str = ""


class Puzzle(Struct, frozen=True):
    """A small figure, and the answer to a question about it.

    Attributes:
        given: the figure in words, a line each: all that is needed for the answer.
        picture: the figure without the answer; None where it cannot be drawn.
        words: what an answer is made of, each with what it means, empty where that is plain.
        answer: the right one; empty for "none".
        one: whether one word is the whole answer.
        why: what makes it so.
    """

    given: tuple[str, ...]
    picture: Picture | None
    words: Mapping[str, str]
    answer: tuple[str, ...]
    one: bool = False
    why: str = ""
