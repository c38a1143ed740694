"""Judging submissions to one problem, one after another, with all that they share.

    with Session(problem, RunOptions(named=False)) as session:
        result = session.judge(source, "mine.py")

Shared are the cases, the box of the reference, the known mistakes, and the lock of who measures. Much of what
judging needs is imported when it is needed, while the first box boots.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext, suppress
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec.structs import replace

from judge.cache import DISK, Store
from judge.errors import JudgeError, ShortageError, UsageError, shortage, told
from judge.judging import RunOptions
from judge.problem import Problem, Verdict
from judge.run.alone import MeasureLock
from judge.run.result import Result, judge_fault
from judge.run.settings import Progress, Reference, Settings, check_needs
from judge.sandbox.boundary import Box, BoxFactory

if TYPE_CHECKING:
    from judge.data import ProblemData
    from judge.mistakes.namer import Namer
    from judge.repair.child import Beside
    from judge.repair.search import Repair
    from judge.run.execute import Judgement
    from judge.run.runner import Runner
    from judge.sandbox import Containment

NAMED = (Verdict.WA, Verdict.RTE)  # the other verdicts do not come from wrong answers
Bars = Callable[[str], AbstractContextManager[Progress | None]]  # opens a bar for work of that label
_SHORT = (ShortageError, OSError, MemoryError, RuntimeError)  # it shows when the box is needed
_UNTIMED = "there is no reference solution in {}: only the limits on CPU time bound it"
_WAITING = "waiting for another of your judges"
_WEAK = "isolation is 'limits': submissions can read your files and use the network; see 'judge doctor'"
_PACKAGE = str(Path(__file__).resolve().parent.parent)


def silent(_label: str) -> AbstractContextManager[Progress | None]:
    """Tells nobody how far the work is."""
    return nullcontext()


class Session(AbstractContextManager["Session"]):
    """A context manager, for one thread; it ends the boxes that are open.

    `bars` opens what is told how far the work is, by its label. Nothing is printed: what a person should know
    is in the results' notes. `open_box` opens a box for any source, at the session's level of isolation.
    """

    def __init__(
        self,
        problem: Problem,
        options: RunOptions = RunOptions(),  # noqa: B008 - frozen
        *,
        jobs: int = 1,
        had: str | None = None,
        bars: Bars = silent,
        boxes: BoxFactory | None = None,
        store: Store = DISK,
    ) -> None:
        """`jobs` processes of this command judge at once, and share what the machine has left; `had` is the
        level of isolation that the command has had before.

        Without `boxes` there are containers. The `store` keeps the data, and what known mistakes answer.
        """
        self._contained: Containment | None = None
        if boxes is None:
            from judge.judging.containment import contained  # not in a tab, which has no processes

            boxes = contained(problem, options, jobs, had)
            self._contained = boxes.boxes.kept()
        self.problem = problem
        self.options = options
        self.bars = bars
        self.open_box = boxes
        self._store = store
        self.reference = Reference(problem, self.open_box)
        self.lock = MeasureLock(waiting=lambda: self.bars(_WAITING))
        self.settings = Settings(self.take, options.timed, self.lock, self.reference, options.program)
        # What is run for its answers waits for nobody's measuring.
        self.untimed = replace(self.settings, measured=False, lock=MeasureLock(patience=0.0))
        self._ahead: dict[tuple[bytes, str], Box] = {}
        self._namer: Namer | None = None

    def __exit__(self, *exc: object) -> None:
        self.close()

    def close(self) -> None:
        """End the boxes that are open or were started ahead; the session can go on, with others."""
        self.reference.close()
        while self._ahead:
            self._ahead.popitem()[1].__exit__(None, None, None)
        if self._contained:
            self._contained.close()

    def boot(self, source: bytes, name: str) -> None:
        """Start the box of a submission that will be judged soon.

        Raises UsageError where the level of isolation that is asked for cannot be had.
        """
        with suppress(*_SHORT):
            self._ahead[source, name] = self.open_box(source, name)

    def take(self, source: bytes, name: str) -> Box:
        """The submission's box, started ahead or now."""
        return self._ahead.pop((source, name), None) or self.open_box(source, name)

    def prepare(self) -> None:
        """Read the problem's data, and start the reference, not wanted yet. Raises as `judge` does."""
        _ = self.data
        if self.options.timed:
            with suppress(*_SHORT):
                self.reference.warm_up()

    @cached_property
    def data(self) -> ProblemData:
        """The cases and what their answers are held against; read or built when first asked for.

        Raises as `judge`.
        """
        from judge.data.load import load_data

        if self.options.timed:
            check_needs(self.problem)
        with self.bars(f"building {self.problem.id}") as advance:
            return load_data(self.problem, store=self._store, seed=self.options.seed, progress=advance)

    def judge(self, source: bytes, name: str, on_verdict: Callable[[Result], None] | None = None) -> Result:
        """Judge one submission as the options say; `on_verdict` hears of a failure before it is explained,
        and again with its smallest case.

        A fault of the problem's or of the judge's own is a result too, JE: it costs this submission alone.

        Raises:
            UsageError: the level of isolation that is asked for cannot be had, or what the reference needs.
            ProblemError: the data cannot be built.
        """
        notes = self.data.notes
        try:
            result = self._judged(source, name, on_verdict)
        except UsageError:
            raise
        except Exception as fault:  # such as a reference that fails on a case
            known = isinstance(fault, JudgeError) or shortage(fault)  # of the machine, not of the code there
            result = judge_fault(self.problem.id, name, told(fault) + ("" if known else _place(fault)))
        return result.noting(*notes, *self.notes(result.isolation))

    def notes(self, isolation: str) -> tuple[str, ...]:
        """A warning where a submission was held by limits only and nobody asked for that."""
        return (_WEAK,) if isolation == "limits" and self.options.isolation is None else ()

    def _judged(self, source: bytes, name: str, on_verdict: Callable[[Result], None] | None) -> Result:
        from judge.run.execute import judge_submission

        options = self.options
        with self.take(source, name) as box:
            with self.bars(name) as advance:
                judged = judge_submission(
                    self.data,
                    source,
                    name,
                    self.settings,
                    box=box,
                    groups=options.chosen(self.problem),
                    on_progress=advance,
                )
            result, runner, _ = judged
            every = len(self.problem.groups)
            result = replace(result, out_of=every if every > len(result.groups) > 0 else 0)
            if runner is None:
                return result
            if result.failure is not None:
                from judge.run.entry import entry_error  # only after a failure
                from judge.run.printed import with_printed

                result = replace(result, hurdle=entry_error(result, runner, box.inspect(), source))
                if result.hurdle is not None:
                    return result
                result = with_printed(result, self.data, runner, box)
            if options.timed and runner.language:
                unbound = result.verdict is Verdict.AC and not result.time.reference
                why = result.time.why or (_UNTIMED.format(runner.language) if unbound else "")
                result = result.noting(why) if why else result
            if on_verdict and result.failure is not None:
                on_verdict(result)
            judged = judged._replace(result=result)
            if options.diagnosed:
                result = self.diagnosed(judged, self.data, box)
                judged = judged._replace(result=self.checked(result, runner, box))
            return self.named(judged, source, box, on_verdict) if options.named else judged.result

    def diagnosed(self, judged: Judgement, data: ProblemData, box: Box) -> Result:
        """The result with the smallest case that breaks the submission in `box`, if there is one.

        A fault in the search is a note and leaves the verdict alone.
        """
        result, runner, does = judged
        if result.failure is None or runner is None:
            return result
        from judge.diagnose.shrink import shrink  # only after a wrong answer

        try:
            with self.lock.judging():
                found = shrink(data, box, runner, result, reference=self.reference)
        except Exception as fault:
            return result.noting(f"no smaller case for {result.submission}: {told(fault)}")
        if found is not None and found.replay is not None:
            found = runner.explained(found, does)
        return replace(result, counterexample=found)

    def checked(self, result: Result, runner: Runner, box: Box) -> Result:
        """The result with what checks of its language find in the case that is shown, run once more."""
        if not runner.language:
            return result
        from judge.problem.model import case_of  # only after a failure in another language
        from judge.sandbox.native import NativeBox

        shown = result.counterexample or result.failure
        if shown is None or shown.input is None or not isinstance(box, NativeBox):
            return result
        case = case_of(shown.input)
        return result.noting(*box.checked(lambda built, limits: runner.ask(built, [case], limits)))

    def named(
        self, judged: Judgement, source: bytes, box: Box, on_verdict: Callable[[Result], None] | None = None
    ) -> Result:
        """The result with its pitfall where there is one; what goes wrong with that is only a note.

        `judged` is what the submission in `box` answers to the session's cases. `on_verdict` hears of the
        result again before the line of the mistake is sought.
        """
        result = judged.result
        if result.verdict not in NAMED:
            return result
        # Whoever waits for the learning sees the verdict meanwhile.
        namer = self._mistakes(f"{result.verdict.value}  {result.submission}; ")
        try:
            from judge.repair.child import Beside

            python = judged.runner is not None and not judged.runner.language
            alone = partial(self._fails_alone, source, result.submission)
            with Beside(self.open_box, source, python=python) as beside:

                def repair() -> Repair | None:
                    if on_verdict:
                        on_verdict(result)
                    return self._repair(judged, box, beside)

                result = namer.named(result, judged.behaviour, beside.features, alone, repair)
        except Exception as fault:  # the verdict is known, and worth more
            result = result.noting(f"the mistake is not named: {told(fault)}")
        notes, namer.notes = namer.notes, []
        return result.noting(*notes)

    def _mistakes(self, told: str) -> Namer:
        """What names mistakes, with a bar for the learning that begins so; imported with the first one."""
        from judge.mistakes.namer import Namer

        if self._namer is None:
            bar = partial(self.bars, f"{told}learning the mistakes of {self.problem.id}, once")
            self._namer = Namer(self.data, self.options.seed, self.untimed, bar, store=self._store)
        return self._namer

    def _repair(self, judged: Judgement, box: Box, beside: Beside) -> Repair | None:
        """What makes it right; sought half as long where everything is one process."""
        from judge.repair.search import seek

        return seek(self.data, judged, box, beside, share=1.0 if self._contained else 0.5)

    def _fails_alone(self, source: bytes, name: str, group: str, case: int) -> bool:
        """Whether the submission fails one case when nothing was called before it."""
        from judge.run.execute import judge_submission
        from judge.run.group import one_case

        alone = judge_submission(one_case(self.data, group, case), source, name, self.untimed)
        return alone.result.verdict is not Verdict.AC


def _place(fault: Exception) -> str:
    """The innermost line of the judge's own that led to a fault, for whoever is to mend it."""
    from traceback import extract_tb  # hardly ever

    own = [step for step in extract_tb(fault.__traceback__) if step.filename.startswith(_PACKAGE)]
    return f" (judge{own[-1].filename.removeprefix(_PACKAGE)}:{own[-1].lineno})"
