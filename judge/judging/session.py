"""Judging submissions to one problem, one after another or several at once, with all that they share.

    with Session(problem, RunOptions(named=False)) as session:
        result = session.judge(source, "mine.py")

Shared are the cases, the box of the reference, the known mistakes, and the turnstile that keeps races alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path

from msgspec.structs import replace

from judge.data.load import ProblemData, load_data
from judge.errors import JudgeError, UsageError, shortage, told
from judge.judging.containment import Containment
from judge.judging.diagnosis import diagnosed
from judge.judging.job import Job, RunOptions
from judge.judging.naming import Bars, Naming
from judge.problem import Problem, Verdict
from judge.run.alone import Machine
from judge.run.execute import run_in
from judge.run.hurdle import with_hurdle
from judge.run.printed import with_printed
from judge.run.reference import check_needs
from judge.run.result import Result, judge_fault
from judge.run.settings import Progress, Settings

_UNTIMED = "there is no reference solution in {}: only the limits on CPU time bound it"
_WAITING = "waiting for another of your judges"
_PACKAGE = str(Path(__file__).resolve().parent.parent)


def silent(_label: str) -> AbstractContextManager[Progress | None]:
    """Tells nobody how far the work is."""
    return nullcontext()


class Session:
    """A context manager, for one thread.

    `containment` is one in which the first submission's box may have been started. `bars` opens what is told
    how far the work is, by its label. Nothing is printed: what a person should know is in the results' notes.
    """

    def __init__(
        self,
        problem: Problem,
        options: RunOptions = RunOptions(),  # noqa: B008 - frozen
        containment: Containment | None = None,
        *,
        bars: Bars = silent,
    ) -> None:
        self.problem = problem
        self.options = options
        self.containment = containment or Containment(problem, options.isolation, program=options.program)
        self.turnstile = Machine(waiting=lambda: self.bars(_WAITING))
        self.settings = Settings(
            box_factory=self.containment.take,
            measured=options.timed,
            turnstile=self.turnstile,
            reference=self.containment.reference,
            program=options.program,
        )
        self.bars = bars
        self._data: ProblemData | None = None
        self._naming: Naming | None = None

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *exc: object) -> None:
        self.containment.__exit__(*exc)

    def boot(self, source: bytes, name: str) -> None:
        """Start the box of the submission that will be judged first, and prepare.

        Raises:
            UsageError: the level of isolation that is asked for cannot be had.
            ProblemError: the data cannot be built.
        """
        self.containment.boot(source, name)
        self.prepare()

    def prepare(self) -> None:
        """Read the problem's data, and start the reference, not wanted yet. Raises as `judge` does."""
        if self.options.timed:
            check_needs(self.problem)
        _ = self.data
        if self.options.timed:
            self.containment.boot_reference()

    @property
    def data(self) -> ProblemData:
        """The cases and what their answers are held against; read or built when first asked for."""
        if self._data is None:
            with self.bars(f"building {self.problem.id}") as advance:
                self._data = load_data(self.problem, seed=self.options.seed, progress=advance)
        return self._data

    def judge(self, source: bytes, name: str) -> Result:
        """Judge one submission as the options say.

        A fault of the problem's or of the judge's own is a result too, JE: it costs this submission alone.

        Raises:
            UsageError: the level of isolation that is asked for cannot be had, or what the reference needs.
            ProblemError: the data cannot be built.
        """
        if self.options.timed:
            check_needs(self.problem)
        data = self.data
        try:
            result = self._judged(data, source, name)
        except UsageError:
            raise
        except JudgeError as fault:  # such as a reference that fails on a case
            result = judge_fault(self.problem.id, name, str(fault))
        except Exception as fault:
            place = "" if shortage(fault) else _place(fault)  # of the machine, and not of the code there
            result = judge_fault(self.problem.id, name, f"{told(fault)}{place}")
        if result.verdict is Verdict.JE:  # it was not held at any level, perhaps
            return result.noting(*data.notes)
        return result.noting(*data.notes, *self.containment.notes(result.isolation))

    def run(self, job: Job) -> Result:
        """`judge` with what a job holds; it must be of this session's problem and options."""
        return self.judge(job.source, job.name)

    @property
    def naming(self) -> Naming:
        """What names mistakes by their answers to the session's cases."""
        if self._naming is None:
            self._naming = Naming(self.data, self.options.seed, self.settings, lambda label: self.bars(label))
        return self._naming

    def _judged(self, data: ProblemData, source: bytes, name: str) -> Result:
        options = self.options
        with self.containment.take(source, name) as box:
            with self.bars(name) as advance:
                settings, groups = self.settings, options.chosen(self.problem)
                judged = run_in(
                    box,
                    self.problem,
                    data,
                    source,
                    name,
                    settings=settings,
                    groups=groups,
                    on_progress=advance,
                )
            left_out = len(self.problem.groups) > len(judged.result.groups) > 0
            result = replace(judged.result, out_of=len(self.problem.groups) if left_out else 0)
            runner = judged.runner
            if runner is not None:
                result = with_hurdle(result, runner, box, source)
                if result.hurdle is not None:
                    return result
                result = with_printed(result, data, runner, box)
                if options.timed and runner.language:
                    result = result.noting(*_of_its_race(result, runner.language))
            if options.diagnosed and runner is not None:
                with self.turnstile.judging():
                    result = diagnosed(result, data, runner, box, self.containment.open_box, judged.behaviour)
        return self.naming.named(result, judged.behaviour, source) if options.named else result


def _of_its_race(result: Result, language: str) -> Iterator[str]:
    """What is to be said of the time of a submission in another language."""
    if result.time.why:
        yield result.time.why
    elif not result.time.reference and result.verdict is Verdict.AC:
        yield _UNTIMED.format(language)


def _place(fault: Exception) -> str:
    """The innermost line of the judge's own that led to a fault, for whoever is to mend it."""
    import traceback  # hardly ever

    for step in reversed(traceback.extract_tb(fault.__traceback__)):
        if step.filename.startswith(_PACKAGE):
            return f" (judge{step.filename[len(_PACKAGE) :]}:{step.lineno})"
    return ""
