"""Who attacks, with which interpreter, and what came of it."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).parent
SECONDS = 150


class Attacker:
    """A user, an interpreter that this user may start, and a copy of the package that this user may read."""

    def __init__(self, name: str, python: str, home: Path, uid: int | None) -> None:
        self.name = name
        self.python = python
        self.home = home
        self.uid = uid
        self._found: dict[str, dict[str, dict[str, Any]]] = {}

    def popen(self, script: str, *arguments: str, **more: Any) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [self.python, str(self.home / "security" / script), *arguments],
            cwd="/",
            env={"PATH": os.environ["PATH"], "PYTHONPATH": str(self.home), "PYTHONDONTWRITEBYTECODE": "1"},
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

    def outcomes(self, level: str, names: list[str]) -> dict[str, dict[str, Any]]:
        """What came of every attack at a level, or in the positive control with level "none"."""
        if level not in self._found:
            found = self.run("driver.py", level, given=json.dumps(names))
            self._found[level] = {outcome["name"]: outcome for outcome in found}
        return self._found[level]

    def require(self, level: str) -> None:
        """Skip where this user cannot have the level here."""
        self.levels = getattr(self, "levels", None) or {row["name"]: row for row in self.run("levels.py")}
        row = self.levels[level]
        if not row["available"]:
            pytest.skip(f"{level} cannot be had here: {row['why_not']} ({row['remedy']})")
