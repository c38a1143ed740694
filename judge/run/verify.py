"""The setter's gate: everything that a problem's folder and its solutions promise, checked.

    data        every case is valid, and every worked example agrees with the reference
    pins        the data, and the mistakes that each group rejects, are those of pins.json
    solutions   each file of solutions/<id>/{accepted,wrong,slow} gets the verdict its folder says, on the
                data of each seed; enough cases reject a wrong one, which is called as its mistake
    times       what [time] names is there

Nothing is printed: what is wrong is in the report.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from judge.data.load import ProblemData, load_data
from judge.data.pins import Kills, differences, pins_file, pins_of, read_pins, write_pins
from judge.errors import ExitCode, JudgeError, ProblemError, UsageError
from judge.languages import NAME as PYTHON
from judge.languages import file_name, language_of
from judge.languages.boxes import AnyBoxes
from judge.languages.signature import signature_of
from judge.problem import Problem, Verdict
from judge.problem.solutions import Kind, Solution, read_solutions
from judge.problem.toml import key_place, meant
from judge.published import Published
from judge.run.edges import Edge
from judge.run.execute import Judged, judge_submission
from judge.run.reference import check_needs
from judge.run.settings import Settings
from judge.sandbox import Boxes, BoxFactory

ENOUGH = 5  # cases of one group that should reject a wrong program: fewer may be chance

Progress = Callable[[str, int, int], None]  # what is being done, how much of it, how much in all


class Fault(Struct, frozen=True):
    """One broken promise: what, where and what to do."""

    what: str
    where: str
    remedy: str = ""

    def __str__(self) -> str:
        return f"{self.where}: {self.what}" + (f"; {self.remedy}" if self.remedy else "")


class MistakeReport(Struct, frozen=True):
    """A mistake: its line of mistakes.py, the group that finds it in most cases, and all that find it.

    Of several programs that make it, it is the one that the fewest `cases` of its group reject.
    """

    name: str
    line: str
    group: str
    cases: int
    groups: tuple[str, ...] = ()


class SolutionReport(Struct, frozen=True):
    """One program's verdict, null where it is `unjudged`, and the groups that it `failed`.

    `name` is its first line; it is `ok` where this is the verdict that its folder wants.
    """

    file: str  # as wrong/absolute-epsilon.py
    name: str
    verdict: Verdict | None
    ok: bool
    failed: tuple[str, ...] = ()
    unjudged: str = ""


class Verified(Published, frozen=True):
    """What was checked of a kata, or of the cards of `judge quiz`, and what is wrong.

    `pins` is "matching", "written" or "differing", and empty where no data were looked at. `warnings` are
    worth a look, and no broken promise.
    """

    problem: str
    faults: tuple[Fault, ...]
    warnings: tuple[Fault, ...] = ()
    groups: int = 0
    cases: int = 0
    cards: int = 0
    pins: str = ""
    solutions: tuple[SolutionReport, ...] = ()
    mistakes: tuple[MistakeReport, ...] = ()
    edges: tuple[Edge, ...] = ()

    @property
    def exit_code(self) -> ExitCode:
        """3 where something is wrong."""
        return ExitCode.FAULT if self.faults else ExitCode.ACCEPTED


class _Tried(NamedTuple):
    """A solution, its row of the report, and what it came to; None where its language is not here.

    `rejecting` is how many cases of each group reject it, of a wrong one.
    """

    solution: Solution
    report: SolutionReport
    judged: Judged | None
    rejecting: Mapping[str, int]


def verify_problem(
    problem: Problem,
    *,
    update_pins: bool = False,
    progress: Progress | None = None,
    box_factory: BoxFactory | None = None,
    kills: Kills | None = None,
    data: Sequence[ProblemData] = (),
    solution: str = "",
    partial: bool = False,
) -> Verified:
    """Check everything; with `update_pins` the data as they are become the pinned ones.

    Where a `solution` is named, no other is judged. A `partial` check, of some groups, lets wrong ones pass.

    Solutions run in boxes of `box_factory`, where there is one. `kills` are the mistakes of mistakes.py that
    each group rejects.
    `data` are the problem's, as `fresh_data` gives them, and those of other seeds; without it the problem's
    are built. A problem whose data cannot be built has that as its one fault. Raises ProblemError only
    where the pins cannot be written, UsageError where a module is not installed that its reference needs, or
    where there is no such solution.
    """
    check_needs(problem)
    try:
        pinned, *others = data or [fresh_data(problem, progress)]
    except ProblemError as error:
        return Verified(problem.id, (fault_of(error, problem.id),))
    solutions, unsound = read_solutions(problem)
    if solution:
        solutions, unsound = (_named(solution, solutions),), ()
    settings = Settings(box_factory=box_factory or AnyBoxes(Boxes(), signature_of(problem)))
    tried = []
    for done, each in enumerate(solutions):
        if progress:
            progress("judging solutions", done, len(solutions))
        tried.append(_tried(each, pinned, settings))
    enough = min(ENOUGH, max(len(each.cases) for each in pinned.groups))
    pins, drift = _check_pins(
        problem,
        pins_of(pinned.groups, _rejected(tried, enough, kills or {})),
        update=update_pins,
        partial=partial or bool(solution),
    )
    checks: list[Iterable[Fault]] = []
    if not solution:
        checks = [
            (fault_of(each, problem.id) for each in unsound),
            _none_accepted(problem, solutions),
            _time_faults(problem, solutions),
        ]
    checks += [_wrong_verdicts(problem, each, others, settings, partial=partial) for each in tried]
    if not partial:
        checks += [_few_cases(problem, tried, enough), _misnamed(problem, solutions)]
    return Verified(
        problem.id,
        tuple(chain(*checks, drift)),
        tuple(_in_vain(pinned)),
        groups=len(pinned.groups),
        cases=sum(len(each.cases) for each in pinned.groups),
        pins=pins,
        solutions=tuple(each.report for each in tried),
    )


def fresh_data(problem: Problem, progress: Progress | None = None, seed: int | None = None) -> ProblemData:
    """The problem's data, or those of a seed, built without a look at the cache. Raises ProblemError."""
    tell = progress or (lambda *_told: None)
    return load_data(problem, seed=seed, progress=lambda *done: tell("building data", *done), store=None)


def fault_of(error: JudgeError, where: str) -> Fault:
    """The error as a fault, of what is at `where` if it does not say itself."""
    return Fault(error.what, error.where or where, error.remedy or "")


def _named(name: str, solutions: Sequence[Solution]) -> Solution:
    """The solution of that name, or file. Raises UsageError."""
    path = Path(name).resolve()
    for each in solutions:
        if name in (each.file, each.path.name) or each.path.resolve() == path:
            return each
    remedy = meant(name, [each.file for each in solutions], "name one of")
    raise UsageError(f"no solution is called {name!r}", remedy=remedy)


def _tried(solution: Solution, data: ProblemData, settings: Settings) -> _Tried:
    row = SolutionReport(solution.file, solution.name, None, True)
    if solution.language:
        from judge.languages.find import why_not  # which starts processes

        if lacking := why_not(solution.language):
            return _Tried(solution, replace(row, unjudged=f"not judged here: {lacking}"), None, {})
    judged = judge_submission(data, solution.source, solution.path.name, settings)
    verdict = judged.result.verdict
    failed = tuple(group.name for group in judged.result.groups if group.verdict is not Verdict.AC)
    row = replace(row, verdict=verdict, ok=solution.kind.allows(verdict), failed=failed)
    behaviour = judged.behaviour if solution.kind is Kind.WRONG else {}
    return _Tried(solution, row, judged, {name: len(each.wrong) for name, each in behaviour.items()})


def _rejected(tried: Iterable[_Tried], enough: int, kills: Kills) -> Kills:
    """The mistakes that each group rejects in enough cases: those of mistakes.py, and those of wrong/."""
    found = {name: set(names) for name, names in kills.items()}
    for each in tried:
        for name, count in each.rejecting.items():
            if count >= enough:
                found.setdefault(name, set()).add(each.solution.name)
    return found


def _check_pins(
    problem: Problem, found: Mapping[str, Any], *, update: bool, partial: bool
) -> tuple[str, list[Fault]]:
    if update:
        write_pins(problem, found)
        return "written", []
    where = f"{problem.id}/{pins_file(problem).name}"
    remedy = f"if that is meant, pin the data with: judge verify {problem.id} --pin"
    try:
        pins = read_pins(problem)
    except ProblemError as error:
        return "differing", [fault_of(error, where)]
    if pins is None:
        return "differing", [Fault("the data are not pinned", where, remedy)]
    if partial:  # which mistakes the groups reject was not measured
        pins = {name: {**pins[name], "kills": found[name]["kills"]} for name in found if name in pins}
    faults = [Fault(what, where, remedy) for what in differences(pins, found)]
    return ("differing" if faults else "matching"), faults


# -- the checks --------------------------------------------------------------------------------------------


def _none_accepted(problem: Problem, solutions: Sequence[Solution]) -> Iterator[Fault]:
    if not any(each.kind is Kind.ACCEPTED for each in solutions):
        folder = problem.solutions / Kind.ACCEPTED.value
        where = f"{problem.solutions.name}/{folder.name}"
        yield Fault("there is no accepted solution", where, f"add one to {folder}")


def _time_faults(problem: Problem, solutions: Sequence[Solution]) -> Iterator[Fault]:
    """What `[time]` names and is no accepted solution in that language: nothing would be raced against it."""
    rule = problem.time
    if rule is None:
        return
    accepted = [each.path.name for each in solutions if each.kind is Kind.ACCEPTED]
    named: dict[tuple[str, ...], str | None] = {("function",): rule.function, ("program",): rule.program}
    named |= {("references", key): name for key, name in rule.references.items()}
    for path, name in named.items():
        if not name:
            continue
        where, language = key_place(problem, ("time", *path)), language_of(name)
        if name not in accepted:
            what = f"[time] names {name!r}, which is not an accepted solution"
            yield Fault(what, where, meant(name, accepted, "name one of"))
        elif path[0] == "references" and (language is None or language.id != path[1]):
            tongue = language.name if language else PYTHON
            what = f"[time.references] names {name!r} for {path[1]}, which is in {tongue}"
            yield Fault(what, where, "name a file in that language")


def _wrong_verdicts(
    problem: Problem, tried: _Tried, others: Sequence[ProblemData], settings: Settings, *, partial: bool
) -> Iterator[Fault]:
    """The verdicts that the folder does not want, on data of other seeds too; nothing is timed there."""
    solution, row, judged, _ = tried
    if judged is None:
        return
    if not row.ok:
        if not (partial and row.verdict is Verdict.AC):
            yield _verdict_fault(problem, solution, judged)
        return
    if solution.language or solution.kind is Kind.SLOW or (partial and solution.kind is Kind.WRONG):
        return
    untimed = replace(settings, measured=False)
    for seed, data in enumerate(others, start=1):
        judged = judge_submission(data, solution.source, solution.path.name, untimed)
        if not solution.kind.allows(judged.result.verdict):
            yield _verdict_fault(problem, solution, judged, f" with --seed {seed}")


def _verdict_fault(problem: Problem, solution: Solution, judged: Judged, seed: str = "") -> Fault:
    result = judged.result
    why = f" ({result.failure.message})" if result.failure else ""
    return Fault(
        f"gets {result.verdict.value} where {solution.kind.wanted} is wanted{why}{seed}",
        f"{problem.solutions.name}/{solution.file}",
        "move it to the folder it belongs to, or correct it or the data",
    )


def _few_cases(problem: Problem, tried: Iterable[_Tried], enough: int) -> Iterator[Fault]:
    """The wrong programs that hardly any case rejects."""
    for each in tried:
        most = max(each.rejecting.values(), default=0)
        if 0 < most < enough:
            yield Fault(f"few cases reject it: {most}", f"{problem.solutions.name}/{each.solution.file}")


def _misnamed(problem: Problem, solutions: Sequence[Solution]) -> Iterator[Fault]:
    """The wrong programs whose file is not called as the mistake that they make."""
    for each in solutions:
        stem, name = each.path.stem, each.name
        if each.kind is Kind.WRONG and name and stem != name and not stem.startswith(f"{name}-"):
            what = f"its docstring names the mistake {name!r}, its file {stem!r}"
            remedy = f"call it {file_name(name)}, or {file_name(f'{name}-…')}"
            yield Fault(what, f"{problem.solutions.name}/{each.file}", remedy)


def _in_vain(data: ProblemData) -> Iterator[Fault]:
    """The groups of which more than half of the draws make no case."""
    for each in data.groups:
        group, vain = each.group, sum(each.attempts)
        if not group.neighbours and vain > group.count:
            what = f"group {group.name!r}: {vain} of {vain + group.count} draws are in vain"
            yield Fault(what, f"{data.problem.id}/problem.py:{group.line}", "draw what can be used")
