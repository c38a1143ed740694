"""Digests of the files of exported packages, without programs: the trees that other judges read."""

from __future__ import annotations

import re
import tempfile
from hashlib import sha256
from pathlib import Path

from judge.packs.export.forms import why_left_out
from judge.packs.export.job import Order, export
from judge.packs.export.metadata import Version
from judge.problem.find import find_problem
from judge.sandbox import Boxes

_MEASURED = re.compile(rb"(?m)^(\s*(time_limit|timelimit)\s*[:=]).*$")


def record(kata: str) -> dict[str, dict[str, str]]:
    """The digest of each file of a kata's packages, by its place; why there is none where that is so."""
    problem = find_problem(kata)
    why = why_left_out(problem)
    if why:
        return {kata: {"left out": why}}
    with tempfile.TemporaryDirectory(prefix="judge-tests-") as folder:
        target = Path(folder)
        order = Order(target, tuple(Version), held=False)
        export(problem, order, Boxes(None), lambda *_: None)
        return {
            kata: {
                str(path.relative_to(target)): _digest(path.read_bytes())
                for path in sorted(target.rglob("*"))
                if path.is_file()
            }
        }


def _digest(content: bytes) -> str:
    return sha256(_MEASURED.sub(rb"\1", content)).hexdigest()[:12]
