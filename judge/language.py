"""Which files are programs to judge: today those of one language. Another one would begin here."""

from __future__ import annotations

import os
from pathlib import PurePath

NAME = "Python"
SUFFIX = ".py"
PATTERN = f"*{SUFFIX}"  # of such files, for a shell and for a person


def is_program(name: str | os.PathLike[str]) -> bool:
    """Whether a file of that name is a program, and not hidden."""
    path = PurePath(name)
    return path.suffix == SUFFIX and not path.name.startswith(".")


def file_name(stem: str) -> str:
    """The name of a program's file."""
    return f"{stem}{SUFFIX}"
