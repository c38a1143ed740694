"""Cases that are drawn, proved and solved, and what their answers are held against, with nothing rounded.

Case i of a group is drawn from the seed text `seed/group/i/attempt`; attempts go on until one is neither
rejected by its draw, nor against the promise, nor already in the group. So a case depends on nothing but the
group's own row and the cases before it.

A group whose cases take turns catches what a program keeps between calls by a key that leaves a parameter
out: a case differs from the one before in a single parameter, the next one in turn. The new value is that of
a case which is drawn, and the exact answer is to be another one.
"""

from __future__ import annotations

import marshal
import math
from collections import Counter
from collections.abc import Callable, Container, Iterator, Sequence
from contextlib import nullcontext
from fractions import Fraction
from functools import cache, partial
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple

from msgspec import Struct

from judge.data import GroupData, Progress, Within, reseeded
from judge.data.draw import Draw, Pick, Rejected, quick, seeded
from judge.errors import UsageError
from judge.problem import Case, Example, Group, Problem, Tolerance
from judge.problem.declare import InvalidCase
from judge.problem.model import EXAMPLES, Parameter
from judge.problem.module import Module, blaming
from judge.values import check, parameters, wire
from judge.values.atoms import Atom, NumberType
from judge.values.types import Entries

if TYPE_CHECKING:
    from judge.values.answers import Exact, Target

FRESH = 32  # cases of a series: no more than a pinned group has
_ATTEMPTS = 1_000  # for one case
_ROUNDS = 2  # of all parameters, until a case that takes turns stands for itself again
_CONTENT = 100  # attempts after which it may have the answer of the case before, as where nothing changes it


class Built(NamedTuple):
    """A valid case with its exact answer, and which attempt at it this was."""

    case: Case
    exact: Exact
    attempt: int = 0


def build(
    problem: Problem,
    module: Module,
    seed: int | None = None,
    progress: Progress | None = None,
    within: Within | None = None,
) -> list[GroupData]:
    """Every group's data. Raises ProblemError, also where a worked example contradicts `solve`."""
    examples: list[Built] = []
    for each in problem.examples:
        with within(EXAMPLES, len(examples) + 1, each.case) if within else nullcontext():
            examples.append(_solved_example(problem, module, each))
    total = sum(group.count for group in problem.groups)
    built: list[GroupData] = []
    for declared in problem.groups:
        group = reseeded(declared, seed)
        made = examples if group.name == EXAMPLES else draw_cases(problem, module, group, within)
        built.append(_aimed(problem, group, made))
        _check_size(problem, built[-1])
        if progress is not None:
            progress(sum(len(each.cases) for each in built), total)
    return built


def draw_cases(problem: Problem, module: Module, group: Group, within: Within | None = None) -> list[Built]:
    """The cases of one group, no two of them equal: 1 and 1.0 are one case. Raises ProblemError."""
    made: list[Built] = []
    taken: set[Case] = set()
    what = f"group {group.name!r}: its draw fails"
    with blaming(problem, what, group.line):
        for number in range(group.count):
            made.append(new_case(problem, module, group, partial(_pick, group, number), made, taken, within))
            taken.add(made[-1].case)
    return made


def new_case(
    problem: Problem,
    module: Module,
    group: Group,
    pick: Callable[[int], Pick],
    before: Sequence[Built] = (),
    taken: Container[Case] = (),
    within: Within | None = None,
) -> Built:
    """A case of a group after those `before`, valid and not `taken`; `pick` has the choices of each attempt.

    Raises ProblemError where none of the attempts makes a case.
    """
    turn = len(before) % (_ROUNDS * len(problem.parameters) + 1) if group.neighbours else 0
    last = before[-1] if turn else None
    vain: Counter[str] = Counter()
    broken = ""
    for attempt in range(_ATTEMPTS):
        draw = Draw(pick(attempt))
        try:
            case = module.draws[group.name](draw)
        except Rejected:
            vain["rejected by its draw"] += 1
            continue
        if fault := shape_fault(problem, case):
            what = f"group {group.name!r}: its draw gives no case: {fault}"
            raise problem.fault(what, "correct what it returns")
        if last is not None:
            at = (turn - 1) % len(case)
            case = (*last.case[:at], case[at], *last.case[at + 1 :])
        if fault := bounds_fault(problem, case):
            what = f"group {group.name!r} draws a case out of bounds: {fault}"
            remedy = "draw others, or widen the parameter's bounds or letters"
            raise problem.fault(what, remedy, group.line)
        try:
            with within(group.name, len(before) + 1, case) if within else nullcontext():
                exact = module.solve(*case)
        except InvalidCase as fault:
            vain["against the promise"] += 1
            broken = f" ({fault})"
            continue
        if case in taken or (last is not None and case == last.case):
            vain["already in the group"] += 1
        elif last is not None and exact == last.exact and attempt < _CONTENT:
            vain["with the answer of the case before"] += 1
        else:
            return Built(case, exact, attempt)
    reason, times = vain.most_common(1)[0]
    what = (
        f"group {group.name!r}: its draw gives no case {len(before) + 1} of {group.count} in {_ATTEMPTS} "
        f"attempts, {times} of them {reason}{broken if reason == 'against the promise' else ''}"
    )
    raise problem.fault(what, "draw more of them, or lower cases", group.line)


def _pick(group: Group, number: int, attempt: int) -> Pick:
    return seeded(f"{group.seed}/{group.name}/{number}/{attempt}")


def _aimed(problem: Problem, group: Group, made: Sequence[Built]) -> GroupData:
    return GroupData(
        group,
        [each.case for each in made],
        [target_of(problem, each.exact, group.tolerance) for each in made],
        tuple(each.attempt for each in made),
    )


def target_of(problem: Problem, answer: Exact, tolerance: Tolerance) -> Target:
    """What an answer is held against. Raises ProblemError where `solve` gave one of another type."""
    with blaming(problem, "solve's answer cannot be used"):
        return check.target(problem.answer, answer, tolerance)


def _check_size(problem: Problem, data: GroupData) -> None:
    """Hold a group's cases, as a function receives them, against the limit on its input."""
    sent = len(marshal.dumps([*map(tuple, problem.calls(data.cases))]))
    most = problem.limits.input_bytes
    if sent > most:
        what = f"group {data.group.name!r} has {sent / 2**20:.1f} MB of cases; input_mb is {most / 2**20:g}"
        remedy = "raise input_mb in [limits], or make fewer or smaller cases"
        raise problem.fault(what, remedy, data.group.line)


def _solved_example(problem: Problem, module: Module, example: Example) -> Built:
    """The worked example, which shows a right answer. Raises ProblemError."""
    file = "statement.md" if problem.entry else "problem.py"
    tolerance = problem.groups[0].tolerance  # that of the examples, where there is a group of them
    try:
        exact = validate(problem, module, example.case)
    except InvalidCase as fault:
        what, remedy = f"the example is invalid: {fault}", "correct the example"
        raise problem.fault(what, remedy, example.line, file) from None
    if not problem.entry:  # its answer is no setter's
        return Built(example.case, exact)
    target = target_of(problem, exact, tolerance)
    outcome = check.check(problem.answer, _as_json(example.wanted), target, lambda: (exact, tolerance))
    if isinstance(outcome, check.Rejection):
        what = f"the example contradicts solve: {outcome.message}"
        raise problem.fault(what, "correct the example's answer, or solve", example.line, "statement.md")
    return Built(example.case, exact)


def _as_json(value: Any) -> Any:
    """A literal as a submission's answer arrives: tuples are lists, and a text says that it is one."""
    if isinstance(value, str):
        return {"word": value}
    if isinstance(value, Entries):
        return {"dict": [[_as_json(key), _as_json(each)] for key, each in value]}
    return [_as_json(each) for each in value] if isinstance(value, list | tuple) else value


# -- what a case must be ------------------------------------------------------------------------------------


def validate(problem: Problem, module: Module, case: Any) -> Exact:
    """The exact answer to what may be a case: its shape, its bounds, then the promise, which `solve` keeps.

    Raises InvalidCase with what is wrong, for a person; ProblemError where `solve` itself fails.
    """
    if fault := shape_fault(problem, case) or bounds_fault(problem, case):
        raise InvalidCase(fault)
    return module.solve(*case)


def shape_fault(problem: Problem, case: Any) -> str | None:
    """What keeps it from being a tuple of values of the parameters' types, their numbers finite, or None."""
    if type(case) is not tuple or len(case) != len(problem.parameters):
        return f"a case must be a tuple of {len(problem.parameters)} arguments"
    pairs = zip(problem.parameters, case, strict=True)
    faults = (parameters.fault(each.type, each.name, value) for each, value in pairs)
    return next(filter(None, faults), None)


def bounds_fault(problem: Problem, case: Case) -> str | None:
    """What of a well-shaped case is beyond its parameter's bounds or letters, or too near to 0, or None.

    The double nearest to a bound, as 0.4999 is written, is within.
    """
    for parameter, value in zip(problem.parameters, case, strict=True):
        low, high, smallest = _bounds(parameter)
        before: Atom | None = None
        for atom, number in parameters.leaves(parameter.type, value):
            if not isinstance(atom, NumberType):
                if wrong := atom.beyond(number):
                    return f"{parameter.name} has {wrong}"
                continue
            if atom is not before:
                before, least = atom, low if atom.low is None else max(low, atom.low)
                most = high if atom.high is None else min(high, atom.high)
            is_beyond = not least <= number <= most
            if is_beyond and (type(number) is int or number not in map(wire.near, (least, most))):
                return f"{parameter.name} has {number!r}, outside {_text(least)} to {_text(most)}"
            if atom.measured and 0 < abs(number) < smallest:
                return f"{parameter.name} has {number!r}, nearer to 0 than {smallest:g} but not 0"
    return None


@cache
def _bounds(parameter: Parameter) -> tuple[Fraction | int, Fraction | int, float]:
    """A parameter's bounds, as ints where they are, which Python compares much faster; and the least double
    that is not below `smallest`: a double is below the one just when it is below the other.
    """
    low, high, smallest = parameter.low, parameter.high, float(parameter.smallest)
    if smallest < parameter.smallest:
        smallest = math.nextafter(smallest, math.inf)
    return low if low.denominator > 1 else int(low), high if high.denominator > 1 else int(high), smallest


def _text(bound: Fraction | int) -> str:
    text = str(bound)
    return text if len(text) <= 24 else f"{text[:4]}… ({len(text.lstrip('-'))} digits)"


# -- fresh cases --------------------------------------------------------------------------------------------


class Fresh(Struct, frozen=True):
    """Fresh cases without end of some groups of a problem; they depend on the seed alone.

    Raises UsageError where none of the groups has such: the examples are what they are.
    """

    problem: Problem
    module: Module
    groups: Sequence[Group]
    seed: int

    def __post_init__(self) -> None:
        if not any(map(_is_fresh, self.groups)):
            names = ", ".join(group.name for group in self.problem.groups if _is_fresh(group))
            what = "these groups have no fresh cases: the examples are no builder's, big cases take too long"
            raise UsageError(what, remedy=f"name one of {names}")

    def series(self) -> Iterator[GroupData]:
        """Some cases of every group in turn, for ever. Raises ProblemError where the problem's code fails."""
        for number in count(1):
            for group in filter(_is_fresh, self.groups):
                yield self._drawn(group, quick(f"{self.seed}/{number}/{group.name}"))

    def _drawn(self, group: Group, pick: Pick) -> GroupData:
        made: list[Built] = []
        what = f"group {group.name!r}: the problem's own code fails on a fresh case"
        with blaming(self.problem, what, group.line):
            for _ in range(FRESH):
                made.append(new_case(self.problem, self.module, group, lambda _: pick, made))
            return _aimed(self.problem, group, made)


def _is_fresh(group: Group) -> bool:
    return group.name != EXAMPLES and group.size is None
