"""The time limit of a package, by the rule of its format.

    legacy     the slowest accepted submission's time × time_multiplier, rounded to whole seconds, 1 at least
    2025-09    limits.time_limit, or else that time × ac_to_time_limit, rounded up to time_resolution

Where it follows from the accepted submissions, these are judged first; what they took is kept in the cache,
by the content of all that it depends on.
"""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

from msgspec import Struct

from judge import __version__
from judge.digest import Digest
from judge.folders import cache_folder
from judge.kept import KeptFile
from judge.packs.foreign.expected import FOLDER
from judge.packs.foreign.look import DESCRIPTION
from judge.packs.foreign.package import Package, TimeRule

ACCEPTED = "accepted"
UNBOUNDED_SECONDS = 60.0  # for an accepted submission, whose time is only now measured


class TimeLimit(Struct, frozen=True):
    """CPU seconds that a test file may take, and the margin beyond which it is certainly too slow.

    `slowest` are those of the slowest accepted submission, where the limit follows from it. `wanted` is the
    limit by the package's rule, which may be more.
    """

    seconds: float
    margin: float
    slowest: float | None = None
    wanted: float = 0.0

    @property
    def lowered(self) -> str:
        """What is to be said of a limit that is lower than the package wants it; empty for others."""
        if self.wanted <= self.seconds:
            return ""
        return (
            f"the time limit is {self.wanted:,g} s by the package's rule, and {self.seconds:g} s are allowed"
        )


UNKNOWN = TimeLimit(UNBOUNDED_SECONDS, UNBOUNDED_SECONDS)
"""The limit for accepted submissions as long as there is none, and for all where none is accepted."""


def limit_of(rule: TimeRule, slowest: float | None) -> TimeLimit:
    """The limit that a rule comes to; `slowest` is not asked for where the rule itself names one."""
    if rule.fixed is not None:
        wanted, slowest = rule.fixed, None
    else:
        assert slowest is not None
        units = math.ceil(slowest * rule.factor / rule.resolution - 1e-9)
        wanted = max(1, units) * rule.resolution
    most = rule.most
    return TimeLimit(min(wanted, most), min(wanted * rule.margin, most), slowest, wanted)


def found_limit(package: Package, level: str, measure: Callable[[], float | None]) -> TimeLimit:
    """The package's limit; `measure` gives the time of its slowest accepted submission.

    `level` is the isolation at which they are run. It is `UNKNOWN` where none is accepted here.
    """
    if package.time.fixed is not None:
        return limit_of(package.time, None)
    kept = KeptFile(cache_folder, "packages", f"{_stem(package)}-", _key(package, level), "times of packages")
    slowest = kept.read(float)
    if slowest is None:
        slowest = measure()
        if slowest is None:
            return UNKNOWN
        kept.write(slowest)
    return limit_of(package.time, slowest)


def _stem(package: Package) -> str:
    return Digest(os.fsencode(package.name)).hex()[:16]


def _key(package: Package, level: str) -> str:
    """A digest of the judge, the machine, and all files that the times depend on."""
    digest = Digest("\0".join((__version__, sys.version, os.uname().nodename, level)).encode())
    for path in _files(package):
        content = package.opened.read(path)
        digest.update(f"\0{package.opened.name_of(path)}\0{len(content)}\0".encode(errors="replace"))
        digest.update(content)
    return digest.hex()[:32]


def _files(package: Package) -> Iterator[Path]:
    opened = package.opened
    yield opened.root / DESCRIPTION
    for folder in (opened.root / "data", opened.root / FOLDER / ACCEPTED):
        yield from opened.walk(folder)
    if package.validator is not None:
        yield from opened.walk(package.validator) if package.validator.is_dir() else [package.validator]
