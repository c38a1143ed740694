"""The setter's gate for mistakes.py: every choice is rendered as a program and judged as a submission is.

    right ways    every right route, plain and in each of its styles, answers all cases rightly
    rejected      every mistake is rejected, unless the file says why no case can tell it
    kills         a group that names the mistake rejects it, in five cases at least, or there is a warning
    containment   a choice answers there as it does here

A mistake without a word in mistakes.toml, or one that no group names, is a fault too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from msgspec import Struct

from judge.data.model import ProblemData
from judge.errors import ProblemError
from judge.mistakes.answers import Behaviour, behaviour
from judge.mistakes.catalogue import FILE
from judge.mistakes.family import Family
from judge.mistakes.known import Program, computed
from judge.mistakes.makers import Maker, read_makers
from judge.problem import Problem
from judge.run.execute import run_submission
from judge.run.settings import Settings
from judge.run.verify import Fault
from judge.sandbox import BoxFactory

ENOUGH = 5  # cases of one group that reject a mistake, below which there is a warning

Progress = Callable[[str, int, int], None]


class ChoicesReport(Struct, frozen=True):
    """What came of a problem's choices: how many there are, what is wrong, and what is weak.

    `made` are the mistakes that they make, `problem` is the problem with all that its groups should catch.
    """

    count: int = 0
    made: frozenset[str] = frozenset()
    faults: tuple[Fault, ...] = ()
    warnings: tuple[Fault, ...] = ()
    problem: Problem | None = None


def verify_choices(
    problem: Problem, data: ProblemData, box_factory: BoxFactory, progress: Progress | None = None
) -> ChoicesReport:
    """Check the problem's mistakes.py, where there is one. Raises JudgeError where nothing can be run."""
    read = read_makers(problem)
    where = f"{problem.solutions.name}/mistakes.py"
    faults = [Fault(each.what, each.where or where, each.remedy or "") for each in read.faults]
    choices = [maker for maker in read.all if maker.choice is not None]
    if read.family is None:
        return ChoicesReport(faults=tuple(faults), problem=read.problem)
    aimed = _aimed(read.problem)
    warnings: list[Fault] = []
    killed: dict[str, set[str]] = {}
    settings = Settings(box_factory=box_factory, measured=False)
    try:
        faults += _wrong_right_ways(read.family, data)
        for done, maker in enumerate(choices):
            if progress:
                progress("judging mistakes", done, len(choices))
            program = maker.program
            result = run_submission(problem, data, program.source, "mistake.py", settings=settings)
            does = behaviour(result)
            if does != {**dict(computed(data, program)), **_beside(does, data)}:
                remedy = "make it depend on nothing but its arguments"
                faults.append(Fault(f"{maker.name} answers otherwise in containment", maker.file, remedy))
            for name, answers in does.items():
                if answers.wrong:
                    killed.setdefault(maker.name, set()).add(name)
            found = _judged(maker, read.family.equal(maker.choice) if maker.choice else "", does, aimed)
            faults += found.faults
            warnings += found.warnings
    except ProblemError as fault:
        faults.append(Fault(fault.what, fault.where or where, fault.remedy or ""))
    faults += _names(choices, aimed, killed, read.problem)
    made = frozenset(maker.name for maker in choices)
    return ChoicesReport(len(choices), made, tuple(faults), tuple(warnings), read.problem)


def _aimed(problem: Problem) -> Mapping[str, Sequence[str]]:
    """The groups that should catch each mistake."""
    found: dict[str, list[str]] = {}
    for group in problem.groups:
        for name in group.kills:
            found.setdefault(name, []).append(group.name)
    return found


def _beside(does: Behaviour, data: ProblemData) -> Behaviour:
    """What is not computed: groups of big cases."""
    big = {each.group.name for each in data.groups if each.group.size is not None}
    return {name: answers for name, answers in does.items() if name in big}


def _wrong_right_ways(family: Family, data: ProblemData) -> Iterator[Fault]:
    for choice in family.right_ways():
        where = family.style_place(choice)
        does = computed(data, Program(family.program(choice).encode(), where, trusted=True))
        failed = [name for name, answers in does.items() if answers.wrong]
        if failed:
            yield Fault(
                f"a right way is rejected by {', '.join(failed)}",
                where,
                "correct it, or write it as a mistake",
            )


def _judged(maker: Maker, equal: str, does: Behaviour, aimed: Mapping[str, Sequence[str]]) -> ChoicesReport:
    """What there is to say of one choice."""
    counts = {name: len(answers.wrong) for name, answers in does.items() if answers.wrong}
    if equal:
        told = Fault(f"{maker.name} is said to be equal, and {next(iter(counts), '')} rejects it", maker.file)
        return ChoicesReport(warnings=(told,) if counts else ())
    if not counts:
        remedy = "add a case that does, or say below it with '# !' why none can"
        return ChoicesReport(
            faults=(Fault(f"no case rejects {maker.name}: {_shown(maker)}", maker.file, remedy),)
        )
    own = {name: counts.get(name, 0) for name in aimed.get(maker.name, ())}
    if own and max(own.values()) < ENOUGH:
        listed = ", ".join(f"{name} {count}" for name, count in own.items())
        most = max(counts, key=lambda name: counts[name])
        few = f"its own groups reject it in few cases ({listed}), {most} in {counts[most]}"
        what = f"{maker.name}, {_shown(maker)}: {few}"
        return ChoicesReport(warnings=(Fault(what, maker.file),))
    return ChoicesReport()


def _shown(maker: Maker) -> str:
    return maker.lines[0].wrong.partition("\n")[0] if maker.lines else "several lines"


def _names(
    choices: Sequence[Maker],
    aimed: Mapping[str, Sequence[str]],
    killed: Mapping[str, set[str]],
    problem: Problem,
) -> Iterator[Fault]:
    for name in sorted({maker.name for maker in choices}):
        first = next(maker for maker in choices if maker.name == name)
        if name not in aimed:
            yield Fault(f"no group's kills name {name!r}", first.file, "name it where it fails")
        if not first.text:
            yield Fault(f"nothing is said of {name!r}", first.file, f"begin a table [{name}] in {FILE}")
        for group in sorted(set(aimed.get(name, ())) - killed.get(name, set())):
            what = f"group {group!r} names {name!r} and accepts every program that makes it"
            remedy = "strengthen its data, or take the name out of its kills"
            yield Fault(what, f"{problem.id}/problem.toml", remedy)
