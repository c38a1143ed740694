"""The registry of broken problems: the sound problem of the fixtures, with one thing changed in each."""

from __future__ import annotations

import shutil
import tomllib
from pathlib import Path
from typing import Any

FIXTURES = Path(__file__).parent / "fixtures"
SOUND = FIXTURES / "problems" / "root-count"
FAULTS: dict[str, dict[str, Any]] = tomllib.loads(
    (FIXTURES / "broken_problems.toml").read_text(encoding="utf-8")
)


def broken(name: str, folder: Path) -> Path:
    """The broken problem of that name, written into `folder`."""
    fault = FAULTS[name]
    made = folder / name
    shutil.copytree(SOUND, made)
    for file, edits in fault.get("edits", {}).items():
        text = (made / file).read_text(encoding="utf-8")
        for old, new in edits.items():
            assert text.count(old) == 1, f"{old!r} is there {text.count(old)} times in {file}"
            text = text.replace(old, new)
        (made / file).write_text(text, encoding="utf-8")
    if "without" in fault:
        (made / fault["without"]).unlink()
    return made
