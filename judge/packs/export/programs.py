"""Which programs a package holds: those of solutions/, each in the folder of the verdict that it gets there.

Of each mistake there is one program, a file of wrong/ before one that mistakes.py makes. A function gets a
driver. What passes where it must not, is too near the time limit or does not run alone is left out and told.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from msgspec import Struct

from judge.data.load import ProblemData
from judge.languages import SUFFIX
from judge.mistakes.makers import Maker, read_makers
from judge.packs.export.cases import Test
from judge.packs.export.driver import as_program, defines, why_not_alone
from judge.packs.export.trial import PATIENCE, SURELY, Trial, time_limit, tried
from judge.problem import Problem, Verdict
from judge.problem.solutions import Kind, Solution, read_solutions
from judge.sandbox.boundary import BoxFactory

FOLDERS = {
    Verdict.AC: "accepted",
    Verdict.WA: "wrong_answer",
    Verdict.RTE: "run_time_error",
    Verdict.TLE: "time_limit_exceeded",
}
_TRIES = 3  # programs of one mistake, until one is rejected

Progress = Callable[[str, int, int], None]


class Exported(Struct, frozen=True):
    """A program of a package: where it lies in `submissions`, and its text."""

    path: str
    source: bytes
    trial: Trial


class LeftOut(Struct, frozen=True):
    """A program that a package does not hold, and why."""

    file: str
    why: str


class Programs(Struct, frozen=True):
    """All of them, and the time limit in seconds that the accepted ones set."""

    held: tuple[Exported, ...]
    left_out: tuple[LeftOut, ...]
    seconds: int


class _Candidate(Struct, frozen=True):
    """A program that may be held: its name in the package, its kind, and where it stands here."""

    name: str
    kind: Kind
    file: str
    source: str


class Exporter:
    """Tries a problem's programs as the package has them, contained, in boxes of `boxes`."""

    def __init__(self, data: ProblemData, tests: Sequence[Test], boxes: BoxFactory) -> None:
        self._data = data
        self._problem: Problem = data.problem
        self._tests = tests
        self._boxes = boxes
        self._left_out: list[LeftOut] = []

    def programs(self, progress: Progress, *, held: bool = True, wrong: int | None = None) -> Programs:
        """All that the package is to hold; where nothing is `held`, only the accepted ones are tried, for
        the time limit. `wrong` bounds the number of mistakes.

        Raises JudgeError where nothing can be run.
        """
        accepted = list(self._files(Kind.ACCEPTED))
        trials = self._trials(accepted, progress, "trying accepted programs")
        right = [trial for trial in trials if trial.verdict is Verdict.AC]
        seconds = time_limit(right)
        if not held:
            return Programs((), (), seconds)
        found = [self._placed(each, trial, seconds) for each, trial in zip(accepted, trials, strict=True)]
        mistakes = list(self._mistakes())
        for makers in mistakes[wrong:] if wrong is not None else []:
            self._leave_out(makers[0].file, f"only {wrong} wrong programs are wanted")
        slow = list(self._files(Kind.SLOW))
        patience = float(SURELY * seconds)
        trials = self._trials(slow, progress, "trying slow programs", patience)
        found += [self._placed(each, trial, seconds) for each, trial in zip(slow, trials, strict=True)]
        found += self._wrong(mistakes[:wrong], progress, patience, seconds)
        return Programs(tuple(each for each in found if each), tuple(self._left_out), seconds)

    def _leave_out(self, file: str, why: str) -> None:
        self._left_out.append(LeftOut(file, why))

    def _files(self, kind: Kind) -> Iterator[_Candidate]:
        for solution in read_solutions(self._problem, kind).programs:
            if why := _foreign(solution):
                self._leave_out(solution.file, why)
            elif candidate := self._candidate(solution.path.name, kind, solution.file, solution.source):
                yield candidate

    def _candidate(self, name: str, kind: Kind, file: str, source: bytes) -> _Candidate | None:
        """The program as a package has it; None where it cannot be one, which is noted."""
        try:
            text = source.decode()
            if why := why_not_alone(text):
                self._leave_out(file, why)
                return None
            if defines(text, self._problem.entry):
                text = as_program(self._problem, text)
        except (SyntaxError, UnicodeDecodeError):
            self._leave_out(file, "it does not compile")
            return None
        return _Candidate(safe_name(name), kind, file, text)

    def _mistakes(self) -> Iterator[list[_Candidate]]:
        """Of each mistake some programs that make it, a file of its name first, then the choices."""
        by_name: dict[str, list[Maker]] = {}
        for maker in sorted(read_makers(self._problem).all, key=lambda each: each.choice is not None):
            if maker.name:
                by_name.setdefault(maker.name, []).append(maker)
        for name, makers in by_name.items():
            file = f"{name}{SUFFIX}"
            candidates = (
                self._candidate(file, Kind.WRONG, name, each.program.source) for each in makers[:_TRIES]
            )
            if usable := [each for each in candidates if each is not None]:
                yield usable

    def _wrong(
        self, mistakes: Sequence[list[_Candidate]], progress: Progress, patience: float, seconds: int
    ) -> Iterator[Exported | None]:
        for done, candidates in enumerate(mistakes, 1):
            trials = self._first_rejected(candidates, patience)
            progress("trying wrong programs", done, len(mistakes))
            yield self._placed(candidates[len(trials) - 1], trials[-1], seconds)

    def _first_rejected(self, candidates: Sequence[_Candidate], patience: float) -> list[Trial]:
        """The trials of a mistake's programs, up to the first that is rejected."""
        trials = []
        for each in candidates:
            trials.append(self._tried(each, patience))
            if trials[-1].verdict is not Verdict.AC:
                break
        return trials

    def _trials(
        self, candidates: Sequence[_Candidate], progress: Progress, what: str, patience: float = PATIENCE
    ) -> list[Trial]:
        found = []
        for each in candidates:
            found.append(self._tried(each, patience))
            progress(what, len(found), len(candidates))
        return found

    def _tried(self, candidate: _Candidate, patience: float) -> Trial:
        return tried(
            self._data, self._tests, candidate.source.encode(), candidate.name, self._boxes, patience
        )

    def _placed(self, candidate: _Candidate, trial: Trial, seconds: int) -> Exported | None:
        """The program in its folder; None where it fits into none, which is noted."""
        if why := _misfit(candidate.kind, trial, seconds):
            self._leave_out(candidate.file, why)
            return None
        return Exported(f"{FOLDERS[trial.verdict]}/{candidate.name}", candidate.source.encode(), trial)


def safe_name(name: str) -> str:
    """A file's name as packages allow it."""
    return re.sub("[^a-zA-Z0-9_.-]", "_", name)


def _foreign(solution: Solution) -> str:
    """Why a solution gets no driver."""
    return "only Python is exported" if solution.language else ""


def _misfit(kind: Kind, trial: Trial, seconds: int) -> str:
    """Why a program fits into no folder; empty where it does."""
    verdict = trial.verdict
    if kind is Kind.ACCEPTED and verdict is not Verdict.AC:
        return f"as a program it is no longer accepted: {verdict.value} on {trial.file or 'every file'}"
    if verdict is Verdict.AC and kind is Kind.SLOW:
        return f"the package's time limit of {seconds} s does not reject it: it takes {trial.seconds:.2f} s"
    if verdict is Verdict.AC and kind is Kind.WRONG:
        return "as a program it is accepted"
    if verdict not in FOLDERS:
        return f"a package has no folder for {verdict.value}"
    if verdict is not Verdict.TLE and kind is not Kind.ACCEPTED and trial.seconds > seconds / 2:
        return f"it is too near the package's time limit of {seconds} s: {trial.seconds:.2f} s"
    return ""
