"""One submission judged on the test files of a package, in their order, up to the first that it fails."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from msgspec import Struct

from judge.errors import JudgeError, UsageError, told
from judge.packs.foreign.cases import DataFile
from judge.packs.foreign.checker import Checker
from judge.packs.foreign.package import Package
from judge.packs.foreign.programs import Program, submission_box
from judge.packs.foreign.timing import TimeLimit
from judge.problem.verdict import Verdict
from judge.run.replies import VERDICTS
from judge.sandbox.boundary import Box, Limits, ProgramResult, Stop
from judge.sandbox.factory import Boxes

Seen = Callable[[int, str], None]  # told of each test file before it is run: how many were, and its name
_PATIENCE, _AT_LEAST = 4.0, 4.0  # wall time for CPU time, and seconds more
EXCERPT = 1000  # bytes of an input, an answer or an output that are shown


class FileResult(Struct, frozen=True):
    """One test file's verdict; `cpu_seconds` and `memory_bytes` of the submission alone."""

    name: str
    verdict: Verdict
    cpu_seconds: float
    memory_bytes: int


class Failure(Struct, frozen=True):
    """The first test file that a submission fails: the beginnings of what is in it, and why.

    `told` is what the output validator wrote. All but `message` is empty where nothing could be run.
    """

    message: str
    test: str = ""
    given: str = ""
    answer: str = ""
    output: str = ""
    told: str = ""


class Judged(Struct, frozen=True):
    """One submission's result.

    `sensitive` says why its verdict may be another one on another machine, or is empty.
    """

    name: str
    language: str
    verdict: Verdict
    tests: tuple[FileResult, ...] = ()
    out_of: int = 0  # test files
    failure: Failure | None = None
    sensitive: str = ""
    isolation: str = ""

    @property
    def slowest(self) -> float:
        """CPU seconds of the test file that took the longest."""
        return max((test.cpu_seconds for test in self.tests), default=0.0)

    @property
    def memory_bytes(self) -> int:
        """The most that any took."""
        return max((test.memory_bytes for test in self.tests), default=0)

    @property
    def passed(self) -> int:
        """How many test files are accepted."""
        return sum(test.verdict is Verdict.AC for test in self.tests)


class Court(Struct, frozen=True):
    """What judging needs: the package, its test files, its checker and the boxes that all is run in."""

    package: Package
    tests: Sequence[DataFile]
    checker: Checker
    boxes: Boxes

    def judged(
        self,
        program: Program,
        limit: TimeLimit,
        goes_on: Callable[[Collection[Verdict]], bool] = lambda _: False,
        seen: Seen = lambda *_: None,
    ) -> Judged:
        """Judge a submission; `goes_on` says, of the verdicts so far, whether one that fails is run further.

        A fault of the judge's own, or of the output validator's, is a result too, JE; so is everything once a
        validator hangs.
        """
        if self.checker.hung:
            return unjudged(program.name, f"not judged: {self.checker.hung}", program.language)
        try:
            with submission_box(program, self.boxes, self.package.memory_bytes) as box:
                fault = box.inspect().fault
                if fault:
                    place = f" (line {fault.line})" if fault.line else ""
                    failed = Failure(f"{fault.message}{place}")
                    return self._ended(program, Verdict.CE, box, failure=failed)
                return self._on_all(program, box, limit, goes_on, seen)
        except UsageError:
            raise
        except JudgeError as fault:
            return unjudged(program.name, told(fault), program.language)

    def _ended(self, program: Program, verdict: Verdict, box: Box, *, failure: Failure) -> Judged:
        out_of, language = len(self.tests), program.language
        return Judged(
            program.name, language, verdict, out_of=out_of, failure=failure, isolation=box.isolation
        )

    def _on_all(
        self,
        program: Program,
        box: Box,
        limit: TimeLimit,
        goes_on: Callable[[Collection[Verdict]], bool],
        seen: Seen,
    ) -> Judged:
        results: list[FileResult] = []
        failure, sensitive, verdict = None, "", Verdict.AC
        for count, test in enumerate(self.tests):
            seen(count, test.name)
            result, failed, close = self._on(test, box, limit)
            results.append(result)
            if failed is None:
                continue
            if failure is None:
                failure, sensitive, verdict = failed, close, result.verdict
            if result.verdict is Verdict.JE:
                failure, verdict = failed, Verdict.JE
                break
            if not goes_on([each.verdict for each in results]):
                break
        return Judged(
            program.name,
            program.language,
            verdict,
            tuple(results),
            len(self.tests),
            failure,
            sensitive,
            box.isolation,
        )

    def _on(self, test: DataFile, box: Box, limit: TimeLimit) -> tuple[FileResult, Failure | None, str]:
        """One test file's result, why it fails, and whether that was a close call."""
        given, answer = (self.package.opened.read(path) for path in (test.given, test.answer))
        run = box.run_program(given, self._limits(limit))
        spent = run.usage.cpu_seconds
        sensitive = ""
        if run.stop is not Stop.ANSWERED:
            verdict, message, said = VERDICTS[run.stop], run.detail, ""
        else:
            checked = self.checker.checked(test, given, answer, run.stdout)
            verdict, message, said = checked.verdict, checked.message, checked.told
        if spent > limit.seconds and verdict not in (Verdict.JE, Verdict.MLE):
            if verdict is not Verdict.TLE:
                sensitive = (
                    f"{spent:.2f} s lie between the limit, {limit.seconds:g} s, "
                    f"and its margin, {limit.margin:g} s: another machine may say {verdict.value}"
                )
            verdict, message = (
                Verdict.TLE,
                f"used {_at_least(run, limit)} of CPU time, {limit.seconds:g} s are allowed",
            )
        why_lower = {
            Verdict.MLE: self.package.lowered.get("memory"),
            Verdict.OLE: self.package.lowered.get("output"),
            Verdict.TLE: limit.lowered,
        }.get(verdict)
        message = f"{message}; {why_lower}" if why_lower else message
        result = FileResult(test.name, verdict, spent, run.usage.memory_bytes)
        if verdict is Verdict.AC:
            return result, None, ""
        failure = Failure(message, test.name, excerpt(given), excerpt(answer), excerpt(run.stdout), said)
        return result, failure, sensitive

    def _limits(self, limit: TimeLimit) -> Limits:
        package, seconds = self.package, max(limit.seconds, limit.margin)
        wall = _PATIENCE * seconds + _AT_LEAST
        return Limits(seconds, wall, package.memory_bytes, package.output_bytes)


def _at_least(run: ProgramResult, limit: TimeLimit) -> str:
    if run.stop is Stop.CPU:
        return f"more than {max(limit.margin, limit.seconds):g} s"
    return f"{run.usage.cpu_seconds:.2f} s"


def unjudged(name: str, why: str, language: str = "") -> Judged:
    """The result of a submission that could not be judged."""
    return Judged(name, language, Verdict.JE, failure=Failure(why))


def excerpt(content: bytes) -> str:
    """The beginning of a text, and how much there is of it where that is more."""
    text = content[:EXCERPT].decode(errors="backslashreplace")
    return text if len(content) <= EXCERPT else f"{text}… ({len(content):,} bytes)"
