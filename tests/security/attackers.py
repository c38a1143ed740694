"""Who attacks, with which interpreter, and what came of it."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Collection, Iterable, Sequence
from itertools import product
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).parent
SECONDS = 150
LEVELS = ("full", "strong", "limits")
USERS = ("plain", "root") if os.geteuid() == 0 else ("plain",)


def by_turns(values: Iterable[Any], *worlds: Sequence[Any]) -> list[Any]:
    """Each value in each world as parameters: by day each in one of them, and the worlds take turns."""
    every = list(product(*worlds))
    return [
        pytest.param(value, *world, marks=[] if turn % len(every) == place else [pytest.mark.nightly])
        for turn, value in enumerate(values)
        for place, world in enumerate(every)
    ]


def matrix(
    names: Iterable[str], levels: Iterable[str], by_day: Collection[tuple[str, str, str]]
) -> list[Any]:
    """Every name at every level as every user, as parameters: by day only what is in `by_day`."""
    every = [(name, level, user) for level in levels for user in USERS for name in names]
    assert set(by_day) <= set(every), set(by_day) - set(every)
    return [pytest.param(*each, marks=[] if each in by_day else [pytest.mark.nightly]) for each in every]


class Attacker:
    """A user, an interpreter that this user may start, and a copy of the package that this user may read."""

    def __init__(self, name: str, python: str, home: Path, uid: int | None) -> None:
        self.name = name
        self.python = python
        self.home = home
        self.uid = uid
        self.resident: Any = None  # as somebody who has the judge, and the layouts it is installed in
        self.installed: dict[str, Any] = {}
        self._found: dict[tuple[str, ...], dict[str, dict[str, Any]]] = {}

    def popen(self, script: str, *arguments: str, **more: Any) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [self.python, str(self.home / "security" / script), *arguments],
            cwd="/",
            env={
                "PATH": os.environ["PATH"],
                "HOME": str(self.home),
                "TMPDIR": str(self.home / "tmp"),  # where what a killed judge leaves goes with the suite
                "PYTHONPATH": str(self.home),
                "PYTHONDONTWRITEBYTECODE": "1",
            },
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            user=self.uid,
            group=self.uid,
            extra_groups=None if self.uid is None else [],
            **more,
        )

    def run(self, script: str, *arguments: str, given: str = "") -> list[Any]:
        """The JSON lines that the script writes."""
        process = self.popen(script, *arguments)
        try:
            out, err = process.communicate(given, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
            raise AssertionError(
                f"{script} took longer than {SECONDS} s: {out[-500:]} {err[-500:]}"
            ) from None
        assert process.returncode == 0, err[-2000:]
        return [json.loads(line) for line in out.splitlines()]

    def outcomes(self, script: str, level: str, names: Sequence[str], given: str) -> dict[str, Any]:
        """What came of each of the attacks, which are made together, once; `given` is how the script is told.

        Level "none" is the positive control.
        """
        key = (script, level, *names)
        if key not in self._found:
            found = self.run(script, level, given=given)
            self._found[key] = {outcome["name"]: outcome for outcome in found}
        return self._found[key]

    def require(self, level: str) -> None:
        """Skip where this user cannot have the level here."""
        self.levels = getattr(self, "levels", None) or {
            row["name"]: row for row in self.run("driver.py", "levels")
        }
        row = self.levels[level]
        if not row["available"]:
            assert not row["possible"], f"{level} is denied where this machine gives it: {row['why_not']}"
            pytest.skip(f"{level} cannot be had here: {row['why_not']} ({row['remedy']})")
