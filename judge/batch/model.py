"""Who submits what, and the row that comes of it: values that every other part of a batch speaks of.

A *submission* is a file of one student. A *task* is what a worker needs to judge one: it can go to another
process or machine. A *row* is what is kept of a submission: the published result, and who judged it where.
"""

from __future__ import annotations

import sys
from functools import cached_property
from typing import Any

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from judge import __version__
from judge.cache import code_key, content_key, digest
from judge.judging import RunOptions, judged_by
from judge.problem import Problem, Verdict
from judge.run.kept import read_result
from judge.run.result import Result, judge_fault

_SIGNS = 12  # of a hash; they tell versions apart, and nobody would forge one
_PARTS = {
    "judge": "the judge",
    "data": "the problem's files",
    "python": "Python",
    "isolation": "the isolation",
    "terms": "the options",
}


class Submission(Struct, frozen=True):
    """A file that a student has submitted; `file` is its path within the class's folder, with slashes.

    `problem` is the problem's id, empty where none is found. `why` says why it is not judged; then it is a
    row of the table (JE), and `source` is empty. `at` is the second of the epoch when it was submitted, as
    the platform says, or else when the file was written.
    """

    student: str
    problem: str
    file: str
    source: bytes = b""
    why: str = ""
    at: float = 0.0

    @property
    def digest(self) -> str:
        """The digest of the source, 64 hex digits: two of one digest and problem are judged once."""
        return digest(self.source)


class Environment(Struct, frozen=True):
    """By what a row was judged: two rows of one environment can be compared; another is judged anew.

    `judge` is the judge's version and the hash of its code, `data` that of the problem's two folders,
    `python` the interpreter's version, `isolation` the level, `terms` the digest of the options that decide
    a verdict.
    """

    judge: str
    data: str
    python: str
    isolation: str
    terms: str

    @classmethod
    def here(cls, problem: Problem, options: RunOptions, isolation: str) -> Environment:
        """By what this process judges the problem at that level of isolation. Raises ProblemError."""
        return cls(
            judge=f"{__version__}+{code_key()[:_SIGNS]}",
            data=content_key(judged_by(problem))[:_SIGNS],
            python=f"{sys.implementation.name} {'.'.join(map(str, sys.version_info[:3]))}",
            isolation=isolation,
            # The isolation is a part of its own.
            terms=digest(msgspec.json.encode(replace(options, isolation=None)))[:_SIGNS],
        )

    def changes(self, before: Environment | None) -> str:
        """In which parts it differs from the one `before`, in words; nothing where there was none."""
        parts = [(name, getattr(before, part, ""), getattr(self, part)) for part, name in _PARTS.items()]
        return ", ".join(f"{name} ({old} → {new})" for name, old, new in parts if old and old != new)


class Task(Struct, frozen=True):
    """What a worker is sent: the problem's id, the file's name for messages, its bytes, how to judge it, and
    the environment that the worker's must be.

    `folders` are folders of problems to look in first, on the machine that sends it.
    """

    problem: str
    name: str
    source: bytes
    options: RunOptions
    environment: Environment
    folders: tuple[str, ...] = ()


class WorkerResult(Struct, frozen=True):
    """What a worker sends back: the published result, and where it was judged.

    `machine` is the host's name, `seconds` the CPU time that the worker and its boxes used for it.
    """

    result: dict[str, Any]
    machine: str = ""
    worker: str = ""
    seconds: float = 0.0

    @classmethod
    def fault(cls, problem: str, name: str, why: str) -> WorkerResult:
        """What there is of a file that could not be judged: JE."""
        return cls(judge_fault(problem, name, why).as_json())


class KeptRow(Struct, frozen=True, dict=True):
    """What is kept of one submission: `digest` is that of the source, `at` the second of the epoch.

    It has no `standard`, which is its environment, where nothing was judged. `copied` names the file of equal
    bytes that was judged in its place, empty where it was judged itself. `small` is the published result with
    its smallest case, once a page has shown it.
    """

    student: str
    problem: str
    file: str
    digest: str
    done: WorkerResult
    standard: Environment | None
    at: float
    copied: str = ""
    small: dict[str, Any] | None = None

    @property
    def key(self) -> str:
        """The digest of the submission and its environment; of two rows with one key the later one stays."""
        return digest(msgspec.json.encode((text_of(self), self.standard)))

    @cached_property
    def result(self) -> Result:
        """What it came to; JE where what is kept cannot be read."""
        try:
            return replace(read_result(self.done.result), submission=self.file)
        except ValueError as fault:
            return judge_fault(self.problem, self.file, str(fault))

    @cached_property
    def smallest(self) -> Result | None:
        """The same with its smallest case, where that is kept and can be read."""
        try:
            return read_result(self.small) if self.small else None
        except ValueError:
            return None

    @property
    def accepted(self) -> bool:
        """Whether the verdict is AC."""
        return self.result.verdict is Verdict.AC

    @property
    def mistake(self) -> str:
        """The name of the mistake behind it, or nothing."""
        return self.result.pitfall.name if self.result.pitfall else ""


def text_of(each: Submission | KeptRow) -> tuple[str, str, str, str]:
    """Whose text it is, for what, in which file, and the digest of the text."""
    return each.student, each.problem, each.file, each.digest
