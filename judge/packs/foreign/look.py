"""Whether a word is a package's, asked before anything of packages is imported."""

from __future__ import annotations

import os

DESCRIPTION = "problem.yaml"
ENDINGS = (".zip", ".kpp")


def is_package(word: str) -> bool:
    """Whether there is a package of that name: a look at two names, which opens nothing."""
    if word.endswith(ENDINGS) and os.path.isfile(word):  # noqa: PTH113 - of any name
        return True
    return os.path.isfile(os.path.join(word, DESCRIPTION))  # noqa: PTH113, PTH118
