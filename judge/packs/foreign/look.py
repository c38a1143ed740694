"""Whether a word is a package's, asked before anything of packages is imported."""

from __future__ import annotations

import os

DESCRIPTION = "problem.yaml"
ENDINGS = (".zip", ".kpp")


def is_package(word: str) -> bool:
    """Whether there is a package of that name, sound or not: a look at two names, which opens nothing."""
    if word.endswith(ENDINGS) and os.path.exists(word) and not os.path.isdir(word):  # noqa: PTH110, PTH112 - of any name
        return True
    return os.path.exists(os.path.join(word, DESCRIPTION))  # noqa: PTH110, PTH118
