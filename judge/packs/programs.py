"""Which programs a package holds: those of solutions/, each in the folder of the verdict that it gets there.

It is the one on the first test that it fails. Of each mistake there is one program, a file of wrong/
before one that mistakes.py makes. A function gets a driver. What passes where it must not, is too near the
time limit or does not run alone is left out and told.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import ceil

from msgspec import Struct

from judge.data import ProblemData
from judge.languages import SUFFIX
from judge.mistakes.family import read_makers
from judge.packs.cases import Test
from judge.packs.driver import as_program, defines, why_not_alone
from judge.packs.metadata import memory
from judge.problem import Problem, Verdict
from judge.problem.solutions import SolutionKind, read_solutions
from judge.run.formatted import FormatRunner
from judge.run.group import GroupRun
from judge.run.program import ProgramRunner
from judge.run.runner import VERDICTS
from judge.sandbox.boundary import BoxFactory, Limits

FOLDERS = {
    Verdict.AC: "accepted",
    Verdict.WA: "wrong_answer",
    Verdict.RTE: "run_time_error",
    Verdict.TLE: "time_limit_exceeded",
}
_NOT_ALLOWED = re.compile("[^a-zA-Z0-9_.-]")  # in the name of a package's file

SLOWEST = 5  # times the slowest accepted program: the time limit, as the legacy format has it
SURELY = 6  # times the time limit: a program that takes so long is too slow elsewhere too
PATIENCE = 20.0  # seconds of CPU for an accepted program and one file
_WALL = 4  # times the CPU seconds, and some

Progress = Callable[[str, int, int], None]


class Included(Struct, frozen=True):
    """A program of the packages: its verdict there, and the test that decides it."""

    file: str
    verdict: Verdict
    test: str | None


class Excluded(Struct, frozen=True):
    """A program that a package does not hold, and why."""

    file: str
    why: str


class Programs(Struct, frozen=True):
    """Those of a package, their `sources` by file, and the seconds that the accepted ones leave to others."""

    included: tuple[Included, ...]
    sources: Mapping[str, bytes]
    excluded: tuple[Excluded, ...]
    seconds: int


class _Candidate(Struct, frozen=True):
    """A program that may be held: its name in the package, its kind, and where it stands here."""

    name: str
    kind: SolutionKind
    file: str
    source: bytes


class _Trial(Struct, frozen=True):
    """What came of it: `test` is the first that it fails, `seconds` the most CPU time of a test."""

    verdict: Verdict
    test: str | None = None
    seconds: float = 0.0


class Exporter:
    """Tries a problem's programs as the package has them, contained, in boxes of `boxes`."""

    def __init__(
        self, data: ProblemData, tests: Sequence[Test], boxes: BoxFactory, progress: Progress
    ) -> None:
        self._data, self._tests, self._boxes, self._progress = data, tests, boxes, progress
        self._problem: Problem = data.problem
        self._runner = (FormatRunner if data.problem.formatted else ProgramRunner)(data.problem)
        self._excluded: dict[Excluded, None] = {}  # each once

    def programs(self, wrong: int | None = None) -> Programs:
        """All that the package is to hold; `wrong` bounds the number of mistakes.

        Raises JudgeError where nothing can be run.
        """
        tried = [*self._tried(self._files(SolutionKind.ACCEPTED), "accepted", PATIENCE)]
        slowest = max((each.seconds for _, each in tried if each.verdict is Verdict.AC), default=0.0)
        seconds = max(1, ceil(SLOWEST * slowest))
        mistakes = list(self._mistakes())
        most = len(mistakes) if wrong is None else wrong
        for each in mistakes[most:]:
            self._exclude(each.file, "no more wrong programs are wanted")
        tried += self._tried(self._files(SolutionKind.SLOW), "slow", SURELY * seconds)
        tried += self._tried(mistakes[:most], "wrong", SURELY * seconds)
        included, sources = [], {}
        for candidate, trial in tried:
            if why := _misfit(candidate.kind, trial, seconds):
                self._exclude(candidate.file, why)
            else:
                file = f"{FOLDERS[trial.verdict]}/{candidate.name}"
                included.append(Included(file, trial.verdict, trial.test))
                sources[file] = candidate.source
        return Programs(tuple(included), sources, tuple(self._excluded), seconds)

    def _exclude(self, file: str, why: str) -> None:
        self._excluded[Excluded(file, why)] = None

    def _files(self, kind: SolutionKind) -> list[_Candidate]:
        found = []
        for each in read_solutions(self._problem, kind).programs:
            if each.language:
                self._exclude(each.file, "only Python is exported")
            elif candidate := self._candidate(each.path.name, kind, each.file, each.source):
                found.append(candidate)
        return found

    def _mistakes(self) -> Iterator[_Candidate]:
        """A program of each mistake, a file of its name before the others."""
        seen: set[str] = set()
        for maker in sorted(read_makers(self._problem).all, key=lambda each: each.program.trusted):
            if maker.name and maker.name not in seen and not maker.offered:
                name, source = f"{maker.name}{SUFFIX}", maker.program.source
                if candidate := self._candidate(name, SolutionKind.WRONG, maker.name, source):
                    seen.add(maker.name)
                    yield candidate

    def _candidate(self, name: str, kind: SolutionKind, file: str, source: bytes) -> _Candidate | None:
        """The program as a package has it; None where it cannot be one, which is noted."""
        problem = self._problem
        reads_input = kind is SolutionKind.ACCEPTED and problem.time and name == problem.time.program
        try:
            text = source.decode()
            why = why_not_alone(text)
            if not reads_input and defines(text, problem.entry):
                if problem.formatted:
                    why = f"it defines {problem.entry} to be called, and reads no input"
                else:
                    text = as_program(problem, text)
        except (SyntaxError, UnicodeDecodeError):
            why = "it does not compile"
        if why:
            self._exclude(file, why)
            return None
        return _Candidate(_NOT_ALLOWED.sub("_", name), kind, file, text.encode())

    def _tried(
        self, candidates: Sequence[_Candidate], what: str, seconds: float
    ) -> Iterator[tuple[_Candidate, _Trial]]:
        """Each program, and what came of it."""
        for done, candidate in enumerate(candidates, 1):
            trial = self._trial(candidate, seconds)
            self._progress(f"trying {what} programs", done, len(candidates))
            yield candidate, trial

    def _trial(self, candidate: _Candidate, seconds: float) -> _Trial:
        """Run the program, contained, on one test after another until one fails, `seconds` of CPU each."""
        memory_bytes, output_bytes = memory(self._problem) << 20, self._problem.limits.output_bytes
        limits = Limits(seconds, _WALL * seconds + 5, memory_bytes, output_bytes)
        most = 0.0
        with self._boxes(candidate.source, candidate.name) as box:
            if box.inspect().fault:
                return _Trial(Verdict.CE)
            for test in self._tests:
                replies = self._runner.ask(box, test.group.cases, limits)
                most = max(most, replies.usage.cpu_seconds)
                run = GroupRun(self._data, test.group, self._runner)
                run.take(replies)
                verdict = VERDICTS.get(replies.stop)  # how a program ends goes before what it has printed
                verdict = verdict or (replies.breakdown.verdict if replies.breakdown else run.verdict)
                if verdict is not Verdict.AC:
                    return _Trial(verdict, test.stem, most)
        return _Trial(Verdict.AC, None, most)


def _misfit(kind: SolutionKind, trial: _Trial, seconds: int) -> str:
    """Why a program fits into no folder; empty where it does."""
    verdict = trial.verdict
    near = f"too near the package's time limit of {seconds} s: it takes {trial.seconds:.2f} s, and must take"
    if kind is SolutionKind.ACCEPTED:
        where = f"{verdict.value} on {trial.test or 'every file'}"
        return "" if verdict is Verdict.AC else f"as a program it is no longer accepted: {where}"
    if verdict is Verdict.AC:
        return "as a program it is accepted" if kind is SolutionKind.WRONG else f"{near} {SURELY * seconds} s"
    if verdict not in FOLDERS:
        return f"a package has no folder for {verdict.value}"
    if verdict is not Verdict.TLE and trial.seconds > seconds / 2:
        return f"{near} at most {seconds / 2} s"
    return ""
