"""Judging a submission from beginning to end, as a value: a job in, a result out. How to judge; a job.

api.py          `judge(problem, source)` and `run(job)`, for other people's programs
session.py      judging many submissions to one problem, with all that they share
containment.py  what is hidden from them; the level of isolation that this machine is known to have
pool.py         who does the work: here, or processes of this machine
cases.py        one case; breaking a wrong program; fresh cases
inprocess.py    a routine of this very process
"""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from judge.cache import code_key, content_key, digest
from judge.problem import Problem
from judge.problem.load import own_files
from judge.problem.model import chosen_groups


class RunOptions(Struct, frozen=True):
    """How submissions are to be judged.

    `groups` are the test groups to run, all where none is named; `seed` builds other cases than the pinned
    ones; `isolation` demands a level instead of the best there is. `timed` says whether an accepted
    submission is raced against the reference, `diagnosed` whether the smallest case is looked for that breaks
    another one, `named` whether the mistake is. With a `level`, only groups of that level of the kata run.
    A `program` is run as one even where it defines the problem's function.
    """

    groups: tuple[str, ...] = ()
    seed: int | None = None
    isolation: str | None = None
    timed: bool = True
    diagnosed: bool = True
    named: bool = True
    level: str | None = None
    program: bool = False

    def chosen(self, problem: Problem) -> tuple[str, ...]:
        """The names of the groups to run. Raises UsageError where that problem has no such group or level."""
        return tuple(group.name for group in chosen_groups(problem, self.groups, self.level))


class Job(Struct, frozen=True):
    """One submission to judge; `folder` and `solutions` are the problem's own, `version` is what they held.

    Two jobs of one `digest` come to the same verdict, wherever they are done.
    """

    folder: str
    solutions: str
    version: str
    name: str
    source: bytes
    options: RunOptions = RunOptions()

    @classmethod
    def of(cls, problem: Problem, source: bytes, name: str, options: RunOptions = RunOptions()) -> Job:  # noqa: B008
        """The job of judging `source`, a file called `name`. Raises ProblemError for an unreadable file."""
        return cls(str(problem.folder), str(problem.solutions), version_of(problem), name, source, options)

    @property
    def problem(self) -> str:
        """The problem's id."""
        return Path(self.folder).name

    @property
    def digest(self) -> str:
        """The digest, in hex, of all that the outcome depends on: not of where the problem lies."""
        plain = (self.problem, self.version, self.name, digest(self.source), self.options)
        return digest(repr(plain).encode())


def version_of(problem: Problem) -> str:
    """The hash of the judge's own code and of all that it judges by in the problem's two folders."""
    return digest(content_key(judged_by(problem)).encode(), code_key().encode())


def judged_by(problem: Problem) -> list[str]:
    """The files of the problem's two folders that it is judged by."""
    solutions = sorted(str(path) for path in problem.solutions.glob("*/*") if path.is_file())
    return [*own_files(problem.folder), *solutions]
