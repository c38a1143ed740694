"""Holding a routine of your own code base against the exact reference, in its own tests.

    from judge.testing import judge_problem

    def test_count():
        judge_problem("count").check(my_count)

The routine is called in this process, so it is trusted; `judge run` contains what is not, and so does
`check_case`, which holds a file against one case. What it does to Decimal's context, the state of `random`
and of numpy, the recursion limit and the filters of warnings is undone after each test group. With the pytest
plug-in of this distribution each group becomes a test of its own; see `judge.pytest_plugin`.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property, partial
from pathlib import Path
from textwrap import wrap
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from judge.data import ProblemData
from judge.data.build import target_of
from judge.data.load import load_data
from judge.errors import UsageError
from judge.judging.clock import Clock
from judge.judging.inprocess import InProcess, Routine
from judge.mistakes.catalogue import told_mistakes
from judge.problem import Group, Problem, Verdict
from judge.problem.find import find_problem
from judge.problem.model import chosen_groups
from judge.repair.features import features
from judge.report.tell import tell
from judge.report.words import counted, printable
from judge.run.group import GroupRun, group_limits, one_case
from judge.run.result import Behaviour, Result, earned
from judge.run.runner import Runner
from judge.run.settings import Progress, Reference, Settings
from judge.sandbox.encode import encode
from judge.values import parameters, show
from judge.values.check import is_right

__all__ = ["Case", "JudgeGroup", "JudgeProblem", "check_case", "judge_problem"]

_SEARCH, _WIDTH = 40.0, 100  # seconds by the clock for a smaller case; columns of a text in pytest's margin


def judge_problem(name: str, *, problems: Sequence[str | os.PathLike[str]] = ()) -> JudgeProblem:
    """The problem of that name; `problems` are folders of problems to look in first.

    Raises UsageError if there is none and ProblemError if it is broken.
    """
    problem = find_problem(name, [Path(folder) for folder in problems])
    if problem.entry:
        return JudgeProblem(problem)
    raise UsageError(f"{name} asks for programs", remedy="judge them on the command line: judge run")


def check_case(replay: str, file: str | os.PathLike[str]) -> None:
    """Hold a submission's file, in any language, against the case of a replay id, as `judge try` does.

    Raises:
        AssertionError: the answer is wrong, or there is none; the text says why.
        UsageError: the id is none, or the file cannot be read.
        ProblemError: the problem is broken.
    """
    __tracebackhide__ = True
    from judge.diagnose.replay import decode, problem_name
    from judge.judging import RunOptions
    from judge.judging.api import read_source
    from judge.judging.cases import ask, try_case
    from judge.judging.session import Session
    from judge.problem.module import load_module

    problem = find_problem(problem_name(replay))
    found = decode(replay, problem, load_module(problem))
    tried = try_case(problem, found.case, found.group.name)
    with Session(problem, RunOptions()) as session:
        said = ask(session, tried, *read_source(Path(file)))
    if said.verdict is not Verdict.AC:
        lines = f"{said.verdict.value}  {said.message}", f"expected {tried.expected}, got {said.got}"
        raise AssertionError("\n".join(map(printable, lines)))


class Case(tuple[Any, ...]):
    """The arguments of a case, which are its attributes by their names too; `f(*case)` calls with them."""

    _data: ProblemData
    _group: Group
    expected: str  # the answer in the nearest doubles

    def accepts(self, answer: object) -> bool:
        """Whether the judge accepts that answer to it. Raises ProblemError."""
        data = self._data
        exact, tolerance = data.exact(self._kept(), self._group)
        target = target_of(data.problem, exact, tolerance)
        return is_right(data.problem.answer, encode(answer), target, lambda: (exact, tolerance))

    def _kept(self) -> tuple[Any, ...]:
        return self._data.problem.kept(tuple(self))

    def _named(self) -> dict[str, Any]:
        pairs = zip(self._data.problem.parameters, self._kept(), strict=True)
        ways = parameters.listed, parameters.argument
        return {each.name: ways[each.type.keyed](each.type, value) for each, value in pairs}

    def __getattr__(self, name: str) -> Any:
        named = {} if name.startswith("_") else self._named()
        if name not in named:
            raise AttributeError(name)
        return named[name]

    def __repr__(self) -> str:
        return f"Case({', '.join(f'{name}={value!r}' for name, value in self._named().items())})"


def _case(data: ProblemData, group: Group, case: Sequence[Any]) -> Case:
    types = [each.type for each in data.problem.parameters]
    made = Case(map(parameters.given, types, case))
    made._data, made._group = data, group
    exact, tolerance = data.exact(tuple(case), group)
    made.expected = show.wanted(data.problem.answer, target_of(data.problem, exact, tolerance))
    return made


class JudgeProblem:
    """A problem to hold routines against. Its data are built once and cached, as for `judge run`."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self._found: dict[Any, Result | None] = {}

    def __repr__(self) -> str:
        return f"judge_problem({self.problem.id!r})"

    @property
    def groups(self) -> tuple[str, ...]:
        """The names of its test groups, in their order."""
        return tuple(group.name for group in self.problem.groups)

    def group(self, name: str) -> JudgeGroup:
        """One of its test groups. Raises UsageError if it has none of that name."""
        (group,) = chosen_groups(self.problem, [name])
        return JudgeGroup(self, name, group.about)

    def check(
        self, routine: Routine, groups: str | Iterable[str] | None = None, seconds: float | None = None
    ) -> None:
        """Call `routine` with every case of the groups, all of them where none are named.

        It takes the problem's parameters in their order, numbers as int or float and points as pairs of
        them, and returns what `judge show` says. Wrap another signature:
        `check(lambda x, y, A, B: mine(Point(x, y), [A, B]))`. For `seconds` see `judge`.

        Raises:
            AssertionError: an answer is wrong, it raised, or the time was over; the text shows the first
                such case of the first such group, what was wanted and got, how many cases of each group fail,
                the smallest case found, and the mistake's name, or the known mistakes that the group should
                catch.
            UsageError: there is no such group, or none is named: nothing would be held against anything.
            ProblemError: the problem is broken.
        """
        __tracebackhide__ = True  # pytest shows the caller's line
        chosen = self.groups if groups is None else (groups,) if isinstance(groups, str) else tuple(groups)
        chosen_groups(self.problem, chosen)
        if not chosen:
            raise UsageError("no group is named", remedy="leave groups out for all of them")
        with _Watched(self.data, routine, seconds) as watched:
            runs, raised = watched.called(chosen)
            failed = any(run.failure for run in runs)
            every = runs if len(runs) == len(self.groups) else None
            found = self._explained(watched, every) if failed else None
        if failed:
            lines = _lines(self.problem, _name(routine), runs, found)
            rows = (printable(row) for text in lines for row in text.splitlines() or [""])
            text = "\n".join(part for row in rows for part in wrap(row, _WIDTH) or [""])
            raise AssertionError(text) from raised

    def judge(self, routine: Routine, seconds: float | None = None) -> Result:
        """What the judge says of the routine: groups, smallest case, mistake; nothing is asserted.

        All of it takes so many `seconds` by the clock. What was left then is not done, and the result is
        `cut_short`; groups that were left have not `run`. A call is ended where it stands if it is Python's,
        in the main thread; else, if it goes on for some seconds more, this process is ended, and says so.

        Raises ProblemError if the problem is broken.
        """
        with _Watched(self.data, routine, seconds) as watched:
            return watched.explained(watched.called(self.groups)[0])

    def cases(self, group: str | None = None) -> list[Case]:
        """The cases of the group, of all without a name. Raises UsageError if there is no such group."""
        chosen = {each.name for each in chosen_groups(self.problem, [group] if group else self.groups)}
        return [
            _case(self.data, each.group, case)
            for each in self.data.groups
            if each.group.name in chosen
            for case in each.cases
        ]

    def strategy(self, group: str) -> Any:
        """A Hypothesis strategy for valid cases of the group, which shrinks along its draw's own choices.

        Raises UsageError if there is no such group, or its cases are not drawn one by one.
        """
        from judge.data.build import validate  # only for who searches
        from judge.diagnose.search import strategy
        from judge.problem.declare import InvalidCase

        (chosen,) = chosen_groups(self.problem, [group])
        data = self.data
        builder = data.module.draws.get(group)
        if builder is None:
            raise UsageError(f"the cases of {group} are not drawn", remedy="name another group")

        def valid(case: Sequence[Any]) -> bool:
            try:
                validate(data.problem, data.module, tuple(case))
            except InvalidCase:
                return False
            return True

        return strategy(builder).filter(valid).map(lambda case: _case(data, chosen, case))

    def _explained(self, watched: _Watched, runs: Sequence[GroupRun] | None) -> Result | None:
        """The smallest case and the mistake's name, sought once for a routine; None where that went wrong.

        `runs` are those of all groups, where it was called with all.
        """
        key = _sameness(watched.routine)
        if key not in self._found:
            try:
                self._found[key] = watched.explained(runs or watched.called(self.groups)[0])
            except Exception:  # what is known of the failure is worth more than what could be
                self._found[key] = None
        return self._found[key]

    @cached_property
    def data(self) -> ProblemData:
        """The cases and what each answer is held against. Raises ProblemError."""
        return load_data(self.problem)


class JudgeGroup(Struct, frozen=True):
    """One test group of a problem, and what it probes in a sentence: what the fixture `judge_group` is."""

    problem: JudgeProblem
    name: str
    about: str

    def __repr__(self) -> str:
        return f"{self.problem!r}.group({self.name!r})"

    def check(self, routine: Routine, seconds: float | None = None) -> None:
        """Call `routine` with every case of the group; see `JudgeProblem.check`."""
        __tracebackhide__ = True
        self.problem.check(routine, [self.name], seconds)


def _sameness(routine: Routine) -> Any:
    """What is equal for a lambda that every test writes anew, with the same values around it."""
    code = getattr(routine, "__code__", None)
    if code is None:
        return id(routine)
    return code, tuple(id(cell.cell_contents) for cell in routine.__closure__ or ())


def _name(routine: Routine) -> str:
    """What a routine is called where it is told of."""
    return getattr(routine, "__qualname__", None) or repr(routine)


class _Late(Exception):  # noqa: N818
    """The time is over while known mistakes are learnt."""


class _Watched:
    """A routine, and the clock that bounds what is asked of it: a context manager."""

    def __init__(self, data: ProblemData, routine: Routine, seconds: float | None) -> None:
        self.routine = routine
        self._data = data
        plugin = sys.modules.get("judge.pytest_plugin")  # which knows where pytest writes
        self._clock = Clock(_name(routine), seconds, getattr(plugin, "stderr", None))

    def __enter__(self) -> _Watched:
        self._clock.start()
        return self

    def __exit__(self, *exc: object) -> None:
        self._clock.close()

    def _box(self) -> InProcess:
        return InProcess(routine=self.routine, watch=lambda _: self._clock)

    def called(
        self, groups: Sequence[str], data: ProblemData | None = None
    ) -> tuple[list[GroupRun], BaseException | None]:
        """What it answers in these groups, and its exception where that is the first failure."""
        runs: list[GroupRun] = []
        raised = None
        data = data or self._data
        runner = Runner(data.problem)
        for each in data.groups:
            if each.group.name in groups:
                box, run = self._box(), GroupRun(data, each, runner)
                run.take(runner.ask(box, each.cases, group_limits(data.problem, each.group)))
                if run.reached < len(run.cases):
                    run.give_up(Verdict.TLE, self._clock.told)
                if run.verdict is Verdict.RTE and not any(one.failure for one in runs):
                    raised = box.raised
                runs.append(run)
        return runs, raised

    def explained(self, runs: Sequence[GroupRun]) -> Result:
        """What `judge run` would say of these runs of all groups, the smallest case, the mistake's name."""
        from judge.diagnose.shrink import shrink  # only after a failure
        from judge.diagnose.trial import SearchBudget

        first = next((run for run in runs if run.failure is not None), None)
        result = Result(
            problem=self._data.problem.id,
            submission=_name(self.routine),
            verdict=first.verdict if first else Verdict.AC,
            failure=first.failure if first else None,
            cut_short=self._clock.cut_short,
            **earned([run.result() for run in runs]),
        )
        if first is None or result.cut_short:
            return result
        runner, budget = Runner(self._data.problem), SearchBudget(wall=min(_SEARCH, self._clock.left))
        with Reference(self._data.problem, InProcess) as reference:
            found = shrink(self._data, self._box(), runner, result, reference=reference, budget=budget)
        result = replace(result, counterexample=found and runner.explained(found))
        with suppress(_Late):
            if not self._clock.spent:
                result = self._named(result, {run.group.name: run.answers for run in runs})
        return replace(result, cut_short=self._clock.cut_short)

    def _named(self, result: Result, does: Behaviour) -> Result:
        from judge.mistakes.namer import Namer
        from judge.repair.search import otherwise

        def alone(group: str, case: int) -> bool:
            (run,), _ = self.called([group], one_case(self._data, group, case))
            return run.failure is not None

        def has() -> frozenset[str]:
            try:  # the file that it is written in; it may be in none
                file = Path(self.routine.__code__.co_filename)
                return frozenset(features(file.read_text(encoding="utf-8")))
            except (AttributeError, OSError, UnicodeDecodeError):
                return frozenset()

        @contextmanager
        def learning() -> Iterator[Progress]:
            def learnt(_done: int, _of: int) -> None:
                if self._clock.spent:
                    raise _Late

            yield learnt

        namer = Namer(self._data, None, Settings(measured=False), learning)
        repair = partial(otherwise, self._data, does, Runner(self._data.problem), self._box())
        return namer.named(result, does, has, alone, repair)


def _lines(problem: Problem, name: str, runs: Sequence[GroupRun], found: Result | None) -> Iterator[str]:
    results = [run.result() for run in runs]
    wrong = [result for result in results if result.run and result.passed < result.cases]
    left = [result for result in results if not result.run]
    lost = sum(len(run.wrong) for run in runs)
    cases = counted(sum(result.cases for result in results), "case")
    several, every = len(results) > 1, counted(len(results), "group")
    groups = f"{len(wrong)} of {every}, " if several else ""
    done = f"is not done with {len(left)} of {every}"
    yield f"{problem.id}: {name} {f'fails {groups}{lost:,} of {cases}' if wrong else done}"
    if several and wrong:
        yield f"  fails  {', '.join(f'{each.name} {each.passed}/{each.cases}' for each in wrong)}"
    if wrong and left:
        yield f"  not run  {', '.join(each.name for each in left)}"
    run = next(run for run in runs if run.failure)
    first = Result(problem=problem.id, submission=name, verdict=run.verdict, failure=run.failure)
    told = tell(problem, found or first)
    yield from ("", *([run.failure.message] if run.given_up and run.failure else told.lines))
    if run.group.kills and not told.mistake and run.verdict is not Verdict.TLE:
        mistakes = told_mistakes(problem)
        yield f"{run.group.name} should catch"
        for kill in run.group.kills:
            yield f"  {kill}: {mistakes[kill]}" if kill in mistakes else f"  {kill}"
