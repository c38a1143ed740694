"""Where languages are described: a folder each, beside this file and where $JUDGE_LANGUAGES says."""

from __future__ import annotations

import os
from pathlib import Path

NAME = "Python"
SUFFIX = ".py"
VARIABLE = "JUDGE_LANGUAGES"  # more folders with such folders, parted by the system's own sign
FILE = "language.toml"


def folders() -> list[Path]:
    """Where the folders of languages are: here, and where `$JUDGE_LANGUAGES` says."""
    more = os.environ.get(VARIABLE, "").split(os.pathsep)
    return [Path(__file__).parent, *(Path(each).absolute() for each in more if each)]


def is_described(language: str) -> bool:
    """Whether there is a language of that id; none is read for that."""
    return language.isidentifier() and any((each / language / FILE).is_file() for each in folders())


def described() -> list[str]:
    """The ids of all languages that are described, by name."""
    return sorted({path.parent.name for each in folders() for path in each.glob(f"*/{FILE}")})
