"""Which files are programs to judge: today those of one language. Another one would begin here."""

from __future__ import annotations

import os
from pathlib import Path, PurePath

NAME = "Python"
SUFFIX = ".py"
PATTERN = f"*{SUFFIX}"  # of such files, for a shell and for a person


def is_program(name: str | os.PathLike[str]) -> bool:
    """Whether a file of that name is a program."""
    return PurePath(name).suffix == SUFFIX


def file_name(stem: str) -> str:
    """The name of a program's file."""
    return f"{stem}{SUFFIX}"


def programs(folder: Path) -> list[Path]:
    """The programs in a folder, in order; none where it cannot be read."""
    return sorted(path for path in folder.glob(PATTERN) if path.is_file())
