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
from judge.data.pins import PINS, Kills, differences, pins_of, read_pins, write_rows
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
from judge.run.execute import Judgement, judge_submission
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
    """A solution, its row of the report, and what it came to; None where its language is not here.

    `rejecting` is how many cases of each group reject it, of a wrong one.
    """

    solution: Solution
    report: SolutionReport
    judged: Judgement | None
    rejecting: Mapping[str, int]


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
        pinned, *others = data = [
            fresh_data(problem, tell, at or None, within) for at in range(options.seeds)
        ]
    except ProblemError as error:
        return Verified(problem.id, (fault_of(error, problem.id),))
    factory = AnyBoxes(boxes or Containment(), signature_of(problem))
    some = bool(options.groups)
    found = ChoicesReport()
    if not options.solution:
        found = verify_choices(problem, data, factory, tell, partial=some)
    settings = Settings(box_factory=factory)
    tried = []
    for done, each in enumerate(solutions):
        tell("judging solutions", done, len(solutions))
        tried.append(_tried(each, pinned, settings))
    enough = min(ENOUGH, max(len(each.cases) for each in pinned.groups))
    kills = pins_of(pinned.groups, _rejected(tried, enough, found.kills))
    pins, drift = _check_pins(problem, kills, update=options.pin, partial=some or bool(options.solution))
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
    checks += [_wrong_verdicts(problem, each, others, settings, partial=some) for each in tried]
    if not some:
        checks.append(_poor_mistakes(problem, tried, enough))
    return Verified(
        problem.id,
        tuple(dict.fromkeys(chain(*checks, drift, found.faults))),
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


def _tried(solution: Solution, data: ProblemData, settings: Settings) -> _Tried:
    row = SolutionReport(solution.file, solution.name, None, True)
    if solution.language:
        from judge.languages.find import why_not  # which starts processes

        if lacking := why_not(solution.language):
            return _Tried(solution, replace(row, unjudged=f"not judged here: {lacking}"), None, {})
    try:
        judged = judge_submission(data, solution.source, solution.path.name, settings)
    except (ProblemError, ShortageError, UsageError):
        raise
    except JudgeError as fault:  # what it is raced against, say, does not come to its end
        return _Tried(solution, replace(row, ok=False, unjudged=str(fault)), None, {})
    verdict = judged.result.verdict
    failed = tuple(group.name for group in judged.result.groups if group.verdict is not Verdict.AC)
    row = replace(row, verdict=verdict, ok=solution.kind.allows(verdict), failed=failed)
    behaviour = judged.behaviour if solution.kind is SolutionKind.WRONG else {}
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


def _wrong_verdicts(
    problem: Problem, tried: _Tried, others: Sequence[ProblemData], settings: Settings, *, partial: bool
) -> Iterator[Fault]:
    """The verdicts that the folder does not want, on data of other seeds too; nothing is timed there.

    In a `partial` set of groups a program that is to be rejected may be right.
    """
    solution, row, judged, _ = tried
    where = f"{problem.solutions.name}/{solution.file}"
    if judged is None:
        if not row.ok:
            yield Fault(f"it cannot be judged: {row.unjudged}", where)
        return
    results, loose = [(judged.result, "")], partial and solution.kind is not SolutionKind.ACCEPTED
    if row.ok and not (solution.language or solution.kind is SolutionKind.SLOW or loose):
        untimed = replace(settings, measured=False)
        for seed, data in enumerate(others, start=1):
            again = judge_submission(data, solution.source, solution.path.name, untimed).result
            results.append((again, f" with --seed {seed}"))
    for result, data_of in results:
        if not (solution.kind.allows(result.verdict) or (loose and result.verdict is Verdict.AC)):
            why = f" ({result.failure.message})" if result.failure else ""
            what = f"gets {result.verdict.value} where {solution.kind.wanted} is wanted{why}{data_of}"
            yield Fault(what, where, "move it to the folder it belongs to, or correct it or the data")


def _poor_mistakes(problem: Problem, tried: Iterable[_Tried], enough: int) -> Iterator[Fault]:
    """The wrong programs that hardly any case rejects, or whose file is not called as their mistake."""
    for each in tried:
        where = f"{problem.solutions.name}/{each.solution.file}"
        stem, name = each.solution.path.stem, each.solution.name
        if 0 < (most := max(each.rejecting.values(), default=0)) < enough:
            yield Fault(f"few cases reject it: {most}", where)
        if each.solution.kind is SolutionKind.WRONG and name and not f"{stem}-".startswith(f"{name}-"):
            what = f"its docstring names the mistake {name!r}, its file {stem!r}"
            yield Fault(what, where, f"call it {file_name(name)}, or {file_name(f'{name}-…')}")


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
