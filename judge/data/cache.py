"""The cache of built data: one file a problem, read whole on a warm start.

    <cache folder>/data/<id>-<place>-<seed>-<key>.json
        {"<group>": [[case, …], [target, …]], …}

`place` stands for the problem's folder, `key` for the content of everything the data are made from. The cache
folder is the user's, or $JUDGE_CACHE.
"""

from __future__ import annotations

import os

from judge.digest import digest_of
from judge.files import cache_folder
from judge.kept import KeptFile
from judge.problem import Problem
from judge.problem.keys import code_key, content_key, own_files

FORMAT = 3  # raise it when the form of the file changes

_CODE = ("exact", "values", "data", "problem", "geometry")  # the packages that the data depend on


class DataCache(KeptFile):
    """The cached data of one problem and one seed."""

    def __init__(self, problem: Problem, seed: int | None) -> None:
        super().__init__(cache_folder, "data", kept_stem(problem, seed), data_key(problem, seed))


def kept_stem(problem: Problem, seed: int | None) -> str:
    """With what the name of a file begins that is kept for this problem, in this place and for a seed."""
    place = digest_of(os.fsencode(problem.folder))[:8]
    return f"{problem.id}-{place}-{'own' if seed is None else 'seeded'}-"


def data_key(problem: Problem, seed: int | None) -> str:
    """The hash of all that the data are made from."""
    return content_key(f"{FORMAT}/{seed}", own_files(problem.folder), code_key(_CODE))
