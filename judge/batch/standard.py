"""By what a row is judged, as far as it can decide a verdict."""

from __future__ import annotations

import sys

import msgspec
from msgspec.structs import replace

from judge import __version__
from judge.batch.model import Standard
from judge.cache import code_key, content_key, digest
from judge.judging.api import RunOptions, judged_by
from judge.judging.session import Session
from judge.languages import file_name
from judge.problem import Problem

_EMPTY = file_name("empty")
_SIGNS = 12  # of a hash; they tell versions apart, and nobody would forge one
_WORDS = {
    "judge": "the judge",
    "data": "the problem's files",
    "python": "Python",
    "isolation": "the isolation",
    "terms": "the options",
}


def standard_of(problem: Problem, options: RunOptions, isolation: str) -> Standard:
    """By what this process judges the problem at that level of isolation. Raises ProblemError."""
    data = content_key(judged_by(problem))[:_SIGNS]
    code = f"{__version__}+{code_key()[:_SIGNS]}"
    return Standard(code, data, _python(), isolation, terms_digest(options))


def terms_digest(options: RunOptions) -> str:
    """The digest of the options that decide a verdict; the isolation is a part of its own."""
    return digest(msgspec.json.encode(replace(options, isolation=None)))[:_SIGNS]


def level_here(problem: Problem, options: RunOptions) -> tuple[str, tuple[str, ...]]:
    """The level of isolation that submissions get here, and what is to be said of it.

    Raises:
        UsageError: the one that is demanded cannot be had.
        JudgeError: none can.
    """
    with Session(problem, options) as session, session.take(b"", _EMPTY) as box:
        box.inspect()
        return box.isolation, session.notes(box.isolation)


def differing(one: Standard, other: Standard) -> str:
    """In which parts they differ, in words; nothing where they agree. An empty part agrees with all."""
    pairs = {part: (getattr(one, part), getattr(other, part)) for part in _WORDS}
    apart = {part: pair for part, pair in pairs.items() if all(pair) and pair[0] != pair[1]}
    return ", ".join(f"{_WORDS[part]} ({before} → {now})" for part, (before, now) in apart.items())


def _python() -> str:
    return f"{sys.implementation.name} {'.'.join(map(str, sys.version_info[:3]))}"
