"""The setter's gate: everything that a problem's folder and its solutions promise, checked.

    data        every case is valid, and every worked example agrees with the reference
    pins        the data are those of pins.json, or of hashes.json
    solutions   each file of solutions/<id>/{accepted,wrong,slow} gets the verdict its folder says
    kills       of a problem whose groups stand in problem.toml: each wrong program fails a group that names
                its mistake, and each group kills what it names

Nothing is printed: what is wrong is in the report.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from judge.data.load import ProblemData, load_data
from judge.data.pins import Kills, differences, pins_file, pins_of, read_pins, write_pins
from judge.errors import ProblemError, UsageError
from judge.languages import NAME as PYTHON
from judge.languages import file_name, language_of
from judge.languages.boxes import AnyBoxes
from judge.languages.model import Language
from judge.languages.signature import signature_of
from judge.problem import Problem, Verdict
from judge.problem.solutions import Kind, Solution, read_solutions
from judge.problem.toml import KeyPath, key_place, meant
from judge.run.execute import judge_submission
from judge.run.matrix import Matrix, kill_matrix
from judge.run.reference import check_needs
from judge.run.result import Result
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


class VerifyReport(Struct, frozen=True):
    """All that was checked; `pins` is "matching", "written", or "differing"."""

    problem: str
    groups: int
    cases: int
    pins: str
    solutions: tuple[SolutionReport, ...]
    faults: tuple[Fault, ...]
    warnings: tuple[Fault, ...] = ()  # what is worth a look, and no broken promise


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
) -> VerifyReport:
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
    tell = progress or (lambda *_told: None)
    try:
        pinned, *others = data or [fresh_data(problem, progress)]
    except ProblemError as error:
        return VerifyReport(problem.id, 0, 0, "differing", (), (_fault_of(error, problem),))
    solutions, unsound = read_solutions(problem)
    if solution:
        solutions, unsound = (_named(solution, solutions),), ()
    faults = [_fault_of(each, problem) for each in unsound]
    if not solution and not any(each.kind is Kind.ACCEPTED for each in solutions):
        folder = problem.solutions / Kind.ACCEPTED.value
        where = f"{problem.solutions.name}/{folder.name}"
        faults.append(Fault("there is no accepted solution", where, f"add one to {folder}"))
    if not solution:
        faults += _time_faults(problem, solutions)
    reports, wrong = [], []
    settings = Settings(box_factory=box_factory or AnyBoxes(Boxes(), signature_of(problem)))
    for done, each in enumerate(solutions):
        tell("judging solutions", done, len(solutions))
        lacking = _lacking(each.language) if each.language else ""
        if lacking:
            told = f"not judged here: {lacking}"
            reports.append(SolutionReport(each.file, each.name, None, True, unjudged=told))
            continue
        judged = judge_submission(pinned, each.source, each.path.name, settings)
        result = judged.result
        ok = each.kind.allows(result.verdict)
        failed = tuple(group.name for group in result.groups if group.verdict is not Verdict.AC)
        reports.append(SolutionReport(each.file, each.name, result.verdict, ok, failed))
        if each.kind is Kind.WRONG and judged.behaviour:
            wrong.append((each.file, each.name, judged.behaviour))
        if not ok and not (partial and result.verdict is Verdict.AC):
            faults.append(_verdict_fault(each, result, problem))
        elif not each.language and not (partial and each.kind is Kind.WRONG):
            faults += _on_other_seeds(problem, others, each, settings)
    sizes = {each.group.name: len(each.cases) for each in pinned.groups}
    matrix = kill_matrix(problem.groups, sizes, wrong)
    if not partial:
        faults += _few(problem, matrix)
        faults += [fault for each in solutions for fault in _name_faults(each, problem)]
    rejected = _rejected(matrix, kills or {})
    found = pins_of(pinned.groups, rejected)
    pins, drift = _check_pins(problem, found, update_pins, partial or bool(solution))
    faults += drift
    return VerifyReport(
        problem=problem.id,
        groups=len(pinned.groups),
        cases=sum(sizes.values()),
        pins=pins,
        solutions=tuple(reports),
        faults=tuple(faults),
        warnings=tuple(_in_vain(pinned)),
    )


def fresh_data(problem: Problem, progress: Progress | None = None, seed: int | None = None) -> ProblemData:
    """The problem's data, or those of a seed, built without a look at the cache. Raises ProblemError."""
    tell = progress or (lambda *_told: None)

    def told(done: int, total: int) -> None:
        tell("building data", done, total)

    return load_data(problem, seed=seed, progress=told, store=None)


def _fault_of(error: ProblemError, problem: Problem) -> Fault:
    return Fault(error.what, error.where or problem.id, error.remedy or "")


def _named(name: str, solutions: Sequence[Solution]) -> Solution:
    """The solution of that name, or file. Raises UsageError."""
    path = Path(name).resolve()
    for each in solutions:
        if name in (each.file, each.path.name) or each.path.resolve() == path:
            return each
    remedy = meant(name, [each.file for each in solutions], "name one of")
    raise UsageError(f"no solution is called {name!r}", remedy=remedy)


def _check_pins(
    problem: Problem, found: Mapping[str, Any], update: bool, partial: bool
) -> tuple[str, list[Fault]]:
    if update:
        write_pins(problem, found)
        return "written", []
    where = f"{problem.id}/{pins_file(problem).name}"
    remedy = f"if that is meant, pin the data with: judge verify {problem.id} --pin"
    try:
        pins = read_pins(problem)
    except ProblemError as error:
        return "differing", [_fault_of(error, problem)]
    if pins is None:
        return "differing", [Fault("the data are not pinned", where, remedy)]
    if partial:  # which mistakes the groups reject was not measured
        pins = {name: {**pins[name], "kills": found[name]["kills"]} for name in found if name in pins}
    faults = [Fault(what, where, remedy) for what in differences(pins, found)]
    return ("differing" if faults else "matching"), faults


def _rejected(matrix: Matrix, kills: Kills) -> Kills:
    """The mistakes that each group rejects in enough cases: those of mistakes.py, and those of wrong/."""
    found = {name: set(kills.get(name, ())) for name in matrix.groups}
    least = _enough(matrix)
    for row in matrix.rows:
        for kill in row.kills:
            if len(kill.rejected) >= least:
                found[kill.group].add(row.mistake)
    return found


def _enough(matrix: Matrix) -> int:
    """In how many cases a group should reject a program: five, or all where no group has so many."""
    return min(ENOUGH, max((kill.cases for row in matrix.rows for kill in row.kills), default=ENOUGH))


def _time_faults(problem: Problem, solutions: Iterable[Solution]) -> list[Fault]:
    """The files that `[time]` names and that are not there: nothing would be raced against them."""
    rule = problem.time
    accepted = [solution.path.name for solution in solutions if solution.kind is Kind.ACCEPTED]
    named: dict[KeyPath, str | None] = {}
    if rule:
        named = {("time", "function"): rule.function, ("time", "program"): rule.program}
        named |= {("time", "references", key): name for key, name in rule.references.items()}
    missing = [
        Fault(
            f"[time] names {name!r}, which is not an accepted solution",
            key_place(problem, path),
            meant(name, accepted, "name one of"),
        )
        for path, name in named.items()
        if name and name not in accepted
    ]
    return missing + [
        _reference_fault(problem, key, name)
        for key, name in (rule.references.items() if rule else ())
        if name in accepted and getattr(language_of(name), "id", "") != key
    ]


def _reference_fault(problem: Problem, key: str, name: str) -> Fault:
    found = language_of(name)
    what = f"[time.references] names {name!r} for {key}, which is in {found.name if found else PYTHON}"
    return Fault(what, key_place(problem, ("time", "references", key)), "name a file in that language")


def _lacking(language: Language) -> str:
    """Why programs in that language cannot be judged on this machine; empty where they can."""
    from judge.languages.find import why_not  # which starts processes

    return why_not(language)


def _few(problem: Problem, matrix: Matrix) -> Iterator[Fault]:
    """The wrong programs that hardly any case rejects."""
    for row in matrix.rows:
        rejecting = max((len(kill.rejected) for kill in row.kills), default=0)
        if 0 < rejecting < _enough(matrix):
            what = f"few cases reject it: {rejecting}"
            yield Fault(what, f"{problem.solutions.name}/{row.file}")


def _in_vain(data: ProblemData) -> Iterator[Fault]:
    """The groups of which more than half of the draws make no case."""
    for each in data.groups:
        group, vain = each.group, sum(each.attempts)
        if not group.neighbours and vain > group.count:
            what = f"group {group.name!r}: {vain} of {vain + group.count} draws are in vain"
            yield Fault(what, f"{data.problem.id}/problem.py:{group.line}", "draw what can be used")


def _on_other_seeds(
    problem: Problem, others: Sequence[ProblemData], solution: Solution, settings: Settings
) -> Iterator[Fault]:
    """The verdicts on data of other seeds that the folder does not want; nothing is timed there."""
    untimed = replace(settings, measured=False)
    for number, data in enumerate(others, start=1):
        if solution.kind is Kind.SLOW:
            return
        judged = judge_submission(data, solution.source, solution.path.name, untimed)
        if not solution.kind.allows(judged.result.verdict):
            fault = _verdict_fault(solution, judged.result, problem)
            yield replace(fault, what=f"{fault.what} with --seed {number}")


def _verdict_fault(solution: Solution, result: Result, problem: Problem) -> Fault:
    why = f" ({result.failure.message})" if result.failure else ""
    return Fault(
        f"gets {result.verdict.value} where {solution.kind.wanted} is wanted{why}",
        f"{problem.solutions.name}/{solution.file}",
        "move it to the folder it belongs to, or correct it or the data",
    )


def _name_faults(solution: Solution, problem: Problem) -> list[Fault]:
    """Whether a wrong program's file is called as the mistake that it makes."""
    stem, name = Path(solution.file).stem, solution.name
    if solution.kind is not Kind.WRONG or not name or stem == name or stem.startswith(f"{name}-"):
        return []
    what = f"its docstring names the mistake {name!r}, its file {stem!r}"
    remedy = f"call it {file_name(name)}, or {file_name(f'{name}-…')}"
    return [Fault(what, f"{problem.solutions.name}/{solution.file}", remedy)]
