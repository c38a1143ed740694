"""What the tests of the command line share."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from broken_problems import broken

ROOT = Path(__file__).parents[2]
PACK = ROOT / "tests" / "fixtures" / "pack"
BROKEN = "broken"  # a folder of broken problems in the current one, once `write_broken` has written it

MEAN = "def middle(a, b):\n    return (a + b) / 2\n"
FLOOR = "def middle(a, b):\n    return (a + b) // 2\n"


def write_broken() -> None:
    """Write the folder of broken problems."""
    for name in ("bad-toml", "misspelt-key", "module-raises"):
        broken(name, Path(BROKEN))


@dataclass(frozen=True)
class Outcome:
    """How a run of the command ended."""

    status: int
    out: str
    err: str

    @property
    def lines(self) -> list[str]:
        return self.out.splitlines()
