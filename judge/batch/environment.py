"""By what a row is judged, as far as it can decide a verdict."""

from __future__ import annotations

import sys

import msgspec
from msgspec.structs import replace

from judge.batch.model import Environment
from judge.cache import code_key, content_key, digest
from judge.judging.options import RunOptions, judged_by
from judge.judging.session import Session
from judge.languages import file_name
from judge.problem import Problem
from judge.version import __version__

_SIGNS = 12  # of a hash; they tell versions apart, and nobody would forge one
_PARTS = {
    "judge": "the judge",
    "data": "the problem's files",
    "python": "Python",
    "isolation": "the isolation",
    "terms": "the options",
}


def environment_of(problem: Problem, options: RunOptions, isolation: str) -> Environment:
    """By what this process judges the problem at that level of isolation. Raises ProblemError."""
    return Environment(
        judge=f"{__version__}+{code_key()[:_SIGNS]}",
        data=content_key(judged_by(problem))[:_SIGNS],
        python=f"{sys.implementation.name} {'.'.join(map(str, sys.version_info[:3]))}",
        isolation=isolation,
        # The isolation is a part of its own.
        terms=digest(msgspec.json.encode(replace(options, isolation=None)))[:_SIGNS],
    )


def level_here(problem: Problem, options: RunOptions) -> tuple[str, tuple[str, ...]]:
    """The level of isolation that submissions get here, and what is to be said of it.

    Raises:
        UsageError: the one that is demanded cannot be had.
        JudgeError: none can.
    """
    with Session(problem, options) as session, session.take(b"", file_name("empty")) as box:
        box.inspect()
        return box.isolation, session.notes(box.isolation)


def differences(before: Environment | None, now: Environment) -> str:
    """In which parts they differ, in words; nothing where they agree, or there was none."""
    parts = [(name, getattr(before, part, ""), getattr(now, part)) for part, name in _PARTS.items()]
    return ", ".join(f"{name} ({old} → {new})" for name, old, new in parts if old and old != new)
