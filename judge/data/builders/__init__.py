"""How test cases are made: recipes over small integers, each of which checks what it built.

    numbers.py      number theory: Bézout, Pythagorean triples, sums of two squares, Pell's equation
    lines.py        a circle and a line in integers, tangent or missing it by a hair or by a mile
    transform.py    what is done to such a figure afterwards: move, mirror, turn, scale, retype
    counting.py     the test families of the two problems that count common points
    posing.py       from a level figure to a case: where endpoints.py and rays.py put their figures
    endpoints.py    the test families of the segment problem
    rays.py         the test families of the ray problem

A builder is a function `(draw, **parameters) -> Case`. It takes every choice from `draw`, so that one recipe
serves the seeded data and a search for the smallest failing case, and it proves its own promise with
`require`.
"""

from __future__ import annotations

from judge.errors import ProblemError

__all__ = ["BuilderError", "require"]


class BuilderError(ProblemError):
    """A recipe built something else than it says: a mistake in the recipe or in its parameters."""


def require(condition: bool, what: str) -> None:
    """Raise BuilderError unless `condition` holds; `what` says what should have been true."""
    if not condition:
        raise BuilderError(f"a builder broke its word: {what}", remedy="check its parameters in problem.toml")
