"""Bubblewraps that fail in a way of their own, for tests of what comes of it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from judge.sandbox import launch

REAL = shutil.which("bwrap")


def pretend(folder: Path, patch: pytest.MonkeyPatch, script: str) -> Path:
    """A bubblewrap that runs `script`; each of its starts is a line of the file that is returned."""
    if REAL is None:
        pytest.skip("bubblewrap is not installed")
    starts, broken = folder / "starts", folder / "bwrap"
    starts.touch()
    broken.write_text(f"#!/bin/sh\necho start >> {starts}\n{script}\n")
    broken.chmod(0o755)
    patch.setattr(launch, "bubblewrap_path", lambda: str(broken))
    return starts


def once(folder: Path, script: str) -> str:
    """A script that runs `script` the first time, and the real bubblewrap from then on."""
    mark = folder / "failed"
    return f'if [ ! -e {mark} ]; then touch {mark}; {script}; fi\nexec {REAL} "$@"'


def count(starts: Path) -> int:
    return len(starts.read_text().splitlines())
