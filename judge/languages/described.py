"""Where languages are described: one TOML file each, beside this one and where $JUDGE_LANGUAGES says."""

from __future__ import annotations

import os
from pathlib import Path

NAME = "Python"
SUFFIX = ".py"
VARIABLE = "JUDGE_LANGUAGES"  # more folders with such files, parted by the system's own sign


def folders() -> list[Path]:
    """Where languages are described: here, and in the folders that `$JUDGE_LANGUAGES` names."""
    more = os.environ.get(VARIABLE, "").split(os.pathsep)
    return [Path(__file__).parent, *(Path(each).absolute() for each in more if each)]


def is_described(language: str) -> bool:
    """Whether there is a language of that id; none is read for that."""
    return language.isidentifier() and any(
        (each / f"{language}.toml").is_file() or (each / language / "language.toml").is_file()
        for each in folders()
    )


def described() -> list[str]:
    """The ids of all languages that are described, by name."""
    old = {path.stem for each in folders() for path in each.glob("*.toml")}
    return sorted(old | {path.parent.name for each in folders() for path in each.glob("*/language.toml")})
