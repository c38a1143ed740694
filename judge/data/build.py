"""Building a problem's cases from its builders, and their targets from its exact answers.

Case i of a group is drawn from the seed text `seed/group/i/attempt`; attempts go on until one is neither
rejected by its builder, nor out of bounds, nor against the promise, nor already in the group. So a case
depends on nothing but the group's own declaration and the cases before it (neighbours.py: it may take all
parameters but one from the last of them).
"""

from __future__ import annotations

import marshal
from collections import Counter
from collections.abc import Callable, Container
from functools import partial
from typing import Any

from judge.data.draw import Draw, RecordedDraw, Rejected, SeededDraw
from judge.data.model import GroupData, Progress, reseeded
from judge.data.neighbours import follows, may_agree, neighbour
from judge.data.validate import Validator
from judge.errors import ProblemError
from judge.problem import Case, Example, Group, Problem, Tolerance
from judge.problem.model import EXAMPLES, group_place
from judge.problem.module import Module, blaming
from judge.values import check
from judge.values.answers import Exact, Target
from judge.values.check import Rejection

_ATTEMPTS = 1_000  # for one case

SolvedCase = tuple[Case, Exact]


def build(
    problem: Problem, module: Module, seed: int | None = None, progress: Progress | None = None
) -> list[GroupData]:
    """Every group's data. Raises ProblemError, also where a worked example contradicts `solve`."""
    examples = _solved_examples(problem, module)
    total = sum(group.count for group in problem.groups)
    done = 0
    built = []
    for declared in problem.groups:
        group = reseeded(declared, seed)
        solved, attempts = (examples, ()) if group.name == EXAMPLES else build_cases(problem, module, group)
        _check_size(problem, group, [case for case, _ in solved])
        targets = [target_of(problem, answer, group.tolerance) for _, answer in solved]
        built.append(GroupData(group, [case for case, _ in solved], targets, attempts))
        done += len(solved)
        if progress is not None:
            progress(done, total)
    return built


def build_cases(problem: Problem, module: Module, group: Group) -> tuple[list[SolvedCase], tuple[int, ...]]:
    """The cases of one group with their exact answers, each proved, and which attempt made it.

    Raises ProblemError.
    """
    validator = Validator(problem, module.solve)
    builder = module.draws[group.name]
    cases: dict[Case, Exact] = {}  # equal cases differ in type at most: 1 and 1.0 are one case
    attempts = [0] * group.count

    def source(number: int, attempt: int) -> Draw:
        attempts[number] = attempt
        return SeededDraw(case_seed(group, number, attempt))

    what = f"group {group.name!r}: its draw fails"
    with blaming(problem, what, lambda: group_place(problem, group.name)):
        for number in range(group.count):
            draws = partial(source, number)
            last = next(reversed(cases.items()), None)
            case, answer = new_case(problem, group, builder, validator, draws, number + 1, cases, last)
            cases[case] = answer
    return list(cases.items()), tuple(attempts)


def _check_size(problem: Problem, group: Group, cases: list[Case]) -> None:
    """Hold a group's cases, as a function receives them, against the limit on its input."""
    sent = len(marshal.dumps([tuple(arguments) for arguments in problem.calls(cases)]))
    most = problem.limits.input_bytes
    if sent > most:
        raise ProblemError(
            f"group {group.name!r} has {sent / 2**20:.1f} MB of cases; input_mb is {most / 2**20:g}",
            where=group_place(problem, group.name),
            remedy="raise input_mb in [limits], or make fewer or smaller cases",
        )


def case_seed(group: Group, number: int, attempt: int) -> str:
    """The seed text of an attempt at case `number` (from 0) of a group."""
    return f"{group.seed}/{group.name}/{number}/{attempt}"


def choices_of(
    group: Group, builder: Callable[[Draw], Any], number: int, case: Case
) -> tuple[int, ...] | None:
    """The choices that case `number` (from 0) of the group was built from; None if it was not."""
    if group.neighbours:
        return None
    attempt = attempt_of(group, builder, number, case)
    if attempt is None:
        return None
    draw = RecordedDraw(SeededDraw(case_seed(group, number, attempt)))
    builder(draw)
    return tuple(draw.choices)


def attempt_of(group: Group, builder: Callable[[Draw], Any], number: int, case: Case) -> int | None:
    """The attempt that made case `number` (from 0) of the group; None if it was not made there."""
    shown = repr(case)  # 1 and 1.0 are two cases here
    for attempt in range(_ATTEMPTS):
        try:
            if repr(builder(SeededDraw(case_seed(group, number, attempt)))) == shown:
                return attempt
        except Rejected:
            continue
    return None


def new_case(
    problem: Problem,
    group: Group,
    builder: Callable[[Draw], Any],
    validator: Validator,
    draws: Callable[[int], Draw],
    number: int,
    taken: Container[Case] = (),
    last: SolvedCase | None = None,
) -> SolvedCase:
    """Case `number` (from 1) of a group and its exact answer: the case is proved and not `taken`.

    `draws` gives the source for each attempt, `last` is the case before. Raises ProblemError where none of
    the attempts makes a case.
    """
    changed = follows(group, number, len(problem.parameters)) if last is not None else None
    failures: Counter[str] = Counter()
    latest: dict[str, str] = {}  # for each reason, what the last such fault was
    for attempt in range(_ATTEMPTS):
        try:
            case = builder(draws(attempt))
        except Rejected:
            failures["rejected by its draw"] += 1
            continue
        if fault := validator.shape(case):
            raise ProblemError(
                f"group {group.name!r}: its draw gives no case: {fault}",
                where=f"{problem.id}/problem.py",
                remedy="correct what it returns",
            )
        if last is not None and changed is not None:
            case = neighbour(last[0], case, changed)
        if fault := validator.bounds(case):
            raise ProblemError(
                f"group {group.name!r} draws a case out of bounds: {fault}",
                where=group_place(problem, group.name),
                remedy="draw smaller numbers, or widen the parameter's bounds",
            )
        proof = validator.promise(case)
        if proof.fault:
            failures["against the promise"] += 1
            latest["against the promise"] = f" ({proof.fault})"
        elif case in taken or (last is not None and changed is not None and case == last[0]):
            failures["already in the group"] += 1
        elif last is not None and changed is not None and proof.answer == last[1] and not may_agree(attempt):
            failures["with the answer of the case before"] += 1
        else:
            return case, proof.answer
    reason, times = failures.most_common(1)[0]
    raise ProblemError(
        f"group {group.name!r}: its draw gives no case {number} of {group.count} "
        f"in {_ATTEMPTS} attempts, {times} of them {reason}{latest.get(reason, '')}",
        where=group_place(problem, group.name),
        remedy="draw more of them, or lower cases",
    )


def _solved_examples(problem: Problem, module: Module) -> list[SolvedCase]:
    """The worked examples and their exact answers, proved; each shows a right answer. Raises ProblemError.

    They are looked at whether or not a group judges by them.
    """
    group = next((each for each in problem.groups if each.name == EXAMPLES), problem.groups[0])
    validator = Validator(problem, module.solve)
    solved = []
    for example in problem.examples:
        where = f"{problem.id}/statement.md:{example.line}"
        proof = validator.proof(example.case)
        if proof.fault:
            what = f"the example is invalid: {proof.fault}"
            raise ProblemError(what, where=where, remedy="correct the example")
        _check_example(problem, example, proof.answer, group.tolerance, where)
        solved.append((example.case, proof.answer))
    return solved


def _check_example(
    problem: Problem, example: Example, answer: Exact, tolerance: Tolerance, where: str
) -> None:
    target = target_of(problem, answer, tolerance)
    outcome = check.check(problem.answer, _as_json(example.wanted), target, lambda: (answer, tolerance))
    if isinstance(outcome, Rejection):
        raise ProblemError(
            f"the example contradicts solve: {outcome.message}",
            where=where,
            remedy="correct the example's answer, or solve",
        )


def target_of(problem: Problem, answer: Exact, tolerance: Tolerance) -> Target:
    """What an answer is held against. Raises ProblemError where `solve` gave one of another type."""
    try:
        return check.target(problem.answer, answer, tolerance)
    except Exception:
        with blaming(problem, "solve's answer cannot be used"):
            raise


def _as_json(value: Any) -> Any:
    """A literal as a submission's answer arrives: tuples are lists, and a word says that it is one."""
    if isinstance(value, str):
        return {"word": value}
    return [_as_json(each) for each in value] if isinstance(value, list | tuple) else value
