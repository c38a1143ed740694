"""The fixture katas of other topics, and the mistake that is looked at closely in each.

What commands say of them is in the transcripts of `topics/`.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from cli_support import ROOT

KATAS = ROOT / "tests" / "fixtures" / "katas"
PROBLEMS, SOLUTIONS = KATAS / "problems", KATAS / "solutions"


@dataclass(frozen=True)
class Kata:
    """A kata, its right solution and a wrong one; `exact` where only one text is right for a program."""

    id: str
    entry: str
    right: str
    mistake: str
    exact: bool = True

    @property
    def accepted(self) -> Path:
        return SOLUTIONS / self.id / "accepted" / f"{self.right}.py"

    @property
    def accepted_program(self) -> Path:
        return SOLUTIONS / self.id / "accepted" / "program.py"

    @property
    def wrong(self) -> Path:
        return SOLUTIONS / self.id / "wrong" / f"{self.mistake}.py"


TABLE = [
    Kata("divisors", "divisors", "trial", "as-found"),
    Kata("positive-root", "positive_root", "formula", "two-roots-only", exact=False),
    Kata("unit-vector", "unit_vector", "hypot", "flat", exact=False),
    Kata("larger-fraction", "compare", "crosswise", "sign-forgotten"),
    Kata("by-size", "by_size", "sorted", "remainder", exact=False),
    Kata("root-enclosed", "enclose", "isqrt", "one-wide", exact=False),
    Kata("rises", "rises", "pairs", "no-standstill"),
    Kata("lamps", "first_lamp", "squares", "last-one"),
]
BY_ID = {kata.id: kata for kata in TABLE}
