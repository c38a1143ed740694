"""What the tests of the command line share."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACK = ROOT / "tests" / "fixtures" / "pack"
BROKEN = "BROKEN"  # a word of a command that stands for a folder of broken problems

MEAN = "def middle(a, b):\n    return (a + b) / 2\n"
FLOOR = "def middle(a, b):\n    return (a + b) // 2\n"


@dataclass(frozen=True)
class Outcome:
    """How a run of the command ended."""

    status: int
    out: str
    err: str

    @property
    def lines(self) -> list[str]:
        return self.out.splitlines()
