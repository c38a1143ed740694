"""The setter's gate: everything that a problem's folder and its solutions promise, checked.

    data        every case is valid, and every worked example agrees with the reference
    pins        the data, and the mistakes that each group rejects, are those of pins.json
    solutions   each file of solutions/<id>/{accepted,wrong,slow} gets the verdict its folder says, on the
                data of each seed; enough cases reject a wrong one, which is called as its mistake
    times       what [time] names is there

Nothing is printed: what is wrong is in the report.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from judge.data import ProblemData, Within
from judge.data.load import load_data
from judge.data.pins import PINS, differences, pins_of, read_pins, write_rows
from judge.errors import JudgeError, ProblemError, ShortageError, UsageError, meant
from judge.languages import NAME as PYTHON
from judge.languages import file_name, language_of
from judge.languages.boxes import AnyBoxes
from judge.languages.signature import signature_of
from judge.problem import Problem, Verdict
from judge.problem.find import typed
from judge.problem.model import chosen_groups
from judge.problem.solutions import Solution, SolutionKind, read_solutions
from judge.problem.toml import key_place
from judge.run.execute import judge_submission
from judge.run.settings import Settings, check_needs
from judge.sandbox import Containment
from judge.verify.edges import edges_of
from judge.verify.formats import format_faults, odd_outputs
from judge.verify.mistakes import ChoicesReport, verify_choices
from judge.verify.model import ENOUGH, Fault, Progress, SolutionReport, Verified, fault_of
from judge.verify.written import draws_twice, own_tokens


class Options(Struct, frozen=True):
    """What to check.

    With `pin` the data as they are become the pinned ones. `seeds` is how many sets of data are checked, the
    pinned ones first. Where `groups` are named, only these are looked at, and wrong programs may pass; where
    a `solution` is, no other is judged, and no mistake. `matrix` tells what reaches each edge.
    """

    pin: bool = False
    seeds: int = 1
    groups: tuple[str, ...] = ()
    solution: str = ""
    matrix: bool = False


class _Tried(NamedTuple):
    """A solution's row of the report, its faults, and in how many cases each group rejects a wrong one."""

    report: SolutionReport
    faults: Sequence[Fault]
    rejecting: Mapping[str, int] = {}


def verify_problem(
    problem: Problem,
    options: Options = Options(),  # noqa: B008 - frozen
    progress: Progress | None = None,
    boxes: Containment | None = None,
    within: Within | None = None,
) -> Verified:
    """Check everything, the solutions in these boxes, where there are some; cases are solved `within` that.

    A problem whose data cannot be built has that as its one fault. Raises UsageError where there is no such
    solution or group, or where a module is not installed that its reference needs; ProblemError where the
    pins cannot be written.
    """
    check_needs(problem)
    tell = progress or (lambda *_told: None)
    if options.groups:
        problem = replace(problem, groups=chosen_groups(problem, options.groups))
    solutions, unsound = read_solutions(problem)
    if options.solution:
        solutions, unsound = (_named(options.solution, solutions),), ()
    try:
        data = [fresh_data(problem, tell, seed or None, within) for seed in range(options.seeds)]
    except ProblemError as error:
        return Verified(problem.id, (fault_of(error, problem.id),))
    pinned = data[0]
    factory = AnyBoxes(boxes or Containment(), signature_of(problem))
    some = bool(options.groups)
    found = ChoicesReport()
    if not options.solution:
        found = verify_choices(problem, data, factory, tell, partial=some)
    settings = Settings(box_factory=factory)
    enough = min(ENOUGH, max(len(each.cases) for each in pinned.groups))
    tried = []
    for done, each in enumerate(solutions):
        tell("judging solutions", done, len(solutions))
        tried.append(_tried(problem, each, data, settings, 0 if some else enough))
    kills = {
        group.name: {each.name for each in found.mistakes if group.name in each.groups}
        | {each.report.name for each in tried if each.rejecting.get(group.name, 0) >= enough}
        for group in problem.groups
    }
    pins, drift = _check_pins(
        problem, pins_of(pinned.groups, kills), update=options.pin, partial=some or bool(options.solution)
    )
    checks: list[Iterable[Fault]] = []
    if not options.solution:
        checks = [
            (fault_of(each, problem.id) for each in unsound),
            _whose(problem),
            _accepted_faults(problem, solutions),
            draws_twice(pinned),
            own_tokens(pinned),
            format_faults(pinned),
        ]
    return Verified(
        problem.id,
        tuple(dict.fromkeys(chain(*checks, *(each.faults for each in tried), drift, found.faults))),
        (*_in_vain(pinned), *_never_called(problem), *odd_outputs(pinned), *found.warnings),
        groups=len(pinned.groups),
        cases=sum(len(each.cases) for each in pinned.groups),
        pins=pins,
        solutions=tuple(each.report for each in tried),
        mistakes=found.mistakes if options.matrix or some else (),
        edges=tuple(edges_of(pinned)) if options.matrix else (),
    )


def fresh_data(
    problem: Problem,
    progress: Progress | None = None,
    seed: int | None = None,
    within: Within | None = None,
) -> ProblemData:
    """The problem's data, or those of a seed, built without a look at the cache. Raises ProblemError."""
    tell = progress or (lambda *_told: None)
    built = partial(tell, "building data")
    return load_data(problem, seed=seed, progress=built, store=None, within=within)


def _named(name: str, solutions: Sequence[Solution]) -> Solution:
    """The solution of that name, or file. Raises UsageError."""
    path = Path(name).resolve()
    for each in solutions:
        if name in (each.file, each.path.name) or each.path.resolve() == path:
            return each
    remedy = meant(name, [each.file for each in solutions], "name one of")
    raise UsageError(f"no solution is called {name!r}", remedy=remedy)


def _tried(
    problem: Problem, solution: Solution, sets: Sequence[ProblemData], settings: Settings, enough: int
) -> _Tried:
    """What a program comes to on the data of each seed; nothing is timed on the others.

    So many cases of a group should reject a wrong one; with 0 the groups are some, and may accept it.
    """
    kind, name, stem = solution.kind, solution.name, solution.path.stem
    row = SolutionReport(solution.file, name, None, True)
    where, faults = f"{problem.solutions.name}/{solution.file}", list[Fault]()
    if enough and kind is SolutionKind.WRONG and name and not f"{stem}-".startswith(f"{name}-"):
        what = f"its docstring names the mistake {name!r}, its file {stem!r}"
        faults.append(Fault(what, where, f"call it {file_name(name)}, or {file_name(f'{name}-…')}"))
    if solution.language:
        from judge.languages.find import why_not  # which starts processes

        if lacking := why_not(solution.language):
            return _Tried(replace(row, unjudged=f"not judged here: {lacking}"), faults)
    rejecting: dict[str, int] = {}
    loose = not enough and kind is not SolutionKind.ACCEPTED
    once = solution.language or kind is SolutionKind.SLOW or loose
    for seed, data in enumerate(sets[:1] if once else sets):
        try:
            settings = replace(settings, measured=not seed)
            result, _, does = judge_submission(data, solution.source, solution.path.name, settings)
        except (ProblemError, ShortageError, UsageError):
            raise
        except JudgeError as fault:  # what it is raced against, say, does not come to its end
            faults.append(Fault(f"it cannot be judged: {fault}", where))
            return _Tried(replace(row, ok=False, unjudged=str(fault)), faults)
        verdict = result.verdict
        if not (ok := kind.allows(verdict)) and not (loose and verdict is Verdict.AC):
            why = f" ({result.failure.message})" if result.failure else ""
            what = f"gets {verdict.value} where {kind.wanted} is wanted{why}"
            what += f" with --seed {seed}" if seed else ""
            remedy = "move it to the folder it belongs to, or correct it or the data"
            faults.append(Fault(what, where, remedy))
        if not seed:
            failed = tuple([group.name for group in result.groups if group.verdict is not Verdict.AC])
            row = replace(row, verdict=verdict, ok=ok, failed=failed)
            if kind is SolutionKind.WRONG:
                rejecting = {group: len(each.wrong) for group, each in does.items()}
            if not ok:
                break
    if 0 < (most := max(rejecting.values(), default=0)) < enough:
        faults.append(Fault(f"few cases reject it: {most}", where))
    return _Tried(row, faults, rejecting)


def _check_pins(
    problem: Problem, found: Mapping[str, Any], *, update: bool, partial: bool
) -> tuple[str, list[Fault]]:
    if update:
        write_rows(problem, PINS, found)
        return "written", []
    where = f"{problem.id}/{PINS}"
    command = f"judge verify {typed(problem)} --pin"
    remedy = f"if that is meant, pin the data with: {command}"
    try:
        pins = read_pins(problem)
    except ProblemError as error:
        return "differing", [fault_of(error, where)]
    if not pins:
        return "missing", [Fault("the data are not pinned", where, f"pin them with: {command}")]
    if partial:  # which mistakes the groups reject was not measured
        pins = {name: {**pins[name], "kills": found[name]["kills"]} for name in found if name in pins}
    faults = [Fault(what, where, remedy) for what in differences(pins, found)]
    return ("differing" if faults else "matching"), faults


# -- the checks --------------------------------------------------------------------------------------------


def _whose(problem: Problem) -> Iterator[Fault]:
    """A license that nobody gives, which verifyproblem calls an error."""
    source = problem.source
    named = source.authors or source.origin or source.license.lower() in ("", "unknown", "public domain")
    if not named:
        what = f"the license is {source.license}, and neither authors nor an origin are named"
        yield Fault(what, key_place(problem, ("source", "license")), "name them in [source]")


def _accepted_faults(problem: Problem, solutions: Sequence[Solution]) -> Iterator[Fault]:
    """No accepted solution, or none of the name and the language of `[time]`: nothing would be raced."""
    accepted = [each.path.name for each in solutions if each.kind is SolutionKind.ACCEPTED]
    if not accepted:
        folder = problem.solutions / SolutionKind.ACCEPTED.value
        where = f"{problem.solutions.name}/{folder.name}"
        yield Fault("there is no accepted solution", where, f"add one to {folder}")
    if (rule := problem.time) is None:
        return
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


def _never_called(problem: Problem) -> Iterator[Fault]:
    """The methods of a class that no worked example calls."""
    if problem.methods:
        called = {call[0] for example in problem.examples for call in example.case[-1]}
        for name in getattr(problem.answer, "place", ()):
            if name not in called:
                yield Fault(f"no example calls {name}", f"{problem.id}/statement.md", "add one")


def _in_vain(data: ProblemData) -> Iterator[Fault]:
    """The groups of which more than half of the draws make no case."""
    for each in data.groups:
        group, vain = each.group, sum(each.attempts)
        if not group.neighbours and vain > group.count:
            what = f"group {group.name!r}: {vain} of {vain + group.count} draws are in vain"
            yield Fault(what, f"{data.problem.id}/problem.py:{group.line}", "draw what can be used")
