"""The setter's gate for mistakes.py: every choice is rendered as a program and called on all cases.

    right ways    every right route, plain and in each of its styles, answers all cases rightly
    rejected      every mistake is rejected, unless the file says why no case can tell it; of the changes that
                  are made in every problem alike, one of a name at least
    kills         each group that names a mistake rejects each program that makes it, in five cases at least
    spared        where mistakes.toml says why a group spares some, it rejects another one so, and another
                  group that one

A mistake without a word in mistakes.toml, or one that no group names, is a fault too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from judge.data.model import ProblemData
from judge.data.pins import Kills
from judge.errors import ProblemError
from judge.mistakes.answers import Behaviour, behaviour
from judge.mistakes.catalogue import FILE, Words
from judge.mistakes.computed import Computer, Program
from judge.mistakes.family import Family
from judge.mistakes.makers import Maker, read_makers
from judge.mistakes.rules import rule_faults
from judge.problem import Problem
from judge.run.execute import run_submission
from judge.run.settings import Settings
from judge.run.verify import ENOUGH, Fault, Least
from judge.sandbox import BoxFactory

Progress = Callable[[str, int, int], None]


class ChoicesReport(Struct, frozen=True):
    """What came of a problem's choices: how many there are, what is wrong, and what is worth a look.

    `made` are the mistakes that they make, `problem` is the problem with all that its groups should catch.
    """

    count: int = 0
    made: frozenset[str] = frozenset()
    faults: tuple[Fault, ...] = ()
    warnings: tuple[Fault, ...] = ()
    problem: Problem | None = None
    kills: Kills = {}
    least: tuple[Least, ...] = ()


def verify_choices(
    problem: Problem,
    data: Sequence[ProblemData],
    box_factory: BoxFactory,
    progress: Progress | None = None,
    *,
    partial: bool = False,
) -> ChoicesReport:
    """Check the problem's mistakes.py, where there is one, on its data: the pinned ones, then of other seeds.

    Where the data are but a `partial` set of groups, no mistake need be rejected.

    Raises JudgeError where nothing can be run.
    """
    read = read_makers(problem)
    where = f"{problem.solutions.name}/mistakes.py"
    faults = [Fault(each.what, each.where or where, each.remedy or "") for each in read.faults]
    choices = [maker for maker in read.all if maker.choice is not None]
    if read.family is None:
        return ChoicesReport(faults=tuple(faults), problem=read.problem)
    warnings: list[Fault] = []
    counts: dict[str, list[_Counted]] = {}
    try:
        computers = [Computer(each) for each in data]
        for computer in computers:
            faults += _wrong_right_ways(read.family, computer)
        for done, maker in enumerate(choices):
            if progress:
                progress("judging mistakes", done, len(choices))
            rejected = [_rejected(maker, computer, data[0], box_factory) for computer in computers]
            if maker.choice is not None and read.family.equal(maker.choice):
                warnings += _still_told(maker, rejected[0])
            else:
                counts.setdefault(maker.name, []).append(_Counted(maker, rejected[0], tuple(rejected)))
    except ProblemError as fault:
        faults.append(Fault(fault.what, fault.where or where, fault.remedy or ""))
    made = frozenset(maker.name for maker in choices)
    report = ChoicesReport(len(choices), made, (), tuple(warnings), read.problem)
    if not problem.in_toml:
        kept = {name: _told_apart(each, read.family) for name, each in counts.items()}
        untagged, unruled = rule_faults(read.family)
        faults += untagged
        if not partial:
            faults += [fault for name, each in kept.items() for fault in _measured(name, each, read.family)]
        return replace(
            report,
            faults=tuple(dict.fromkeys(faults)),
            warnings=(*warnings, *unruled),
            kills=_kills_measured(kept, read.problem),
            least=tuple(each.least for every in kept.values() for each in every),
        )
    aimed = _aimed(read.problem)
    faults += _names(choices, aimed)
    for name in sorted(
        counts.keys() | {name for name, words in read.family.catalogue.items() if words.spared}
    ):
        words = read.family.words(name)
        counted = _told_apart(counts.get(name, ()), read.family)
        faults += _kills(name, counted, aimed.get(name, ()), words, read.problem)
    return replace(report, faults=tuple(faults))


def _rejected(maker: Maker, computer: Computer, data: ProblemData, box_factory: BoxFactory) -> dict[str, int]:
    """In how many cases of each group a mistake is rejected; groups that accept it are left out."""
    does = computer.behaviour(maker.program)
    counts = {name: len(answers.wrong) for name, answers in does.items() if answers.wrong}
    if data.problem.in_toml or max(counts.values(), default=0) < ENOUGH:
        big = _on_big_cases(maker, data, box_factory)
        counts |= {name: len(answers.wrong) for name, answers in big.items() if answers.wrong}
    return counts


def _measured(name: str, counted: Sequence[_Counted], family: Family) -> Iterator[Fault]:
    """Whether every program that makes a mistake is rejected in enough cases of some group, on each seed."""
    words = family.words(name)
    catalogue = f"{family.problem.solutions.parent.name}/{FILE}"
    for each in counted:
        least = each.least
        remedy = "strengthen a group, or say below it with '# !' why none can"
        if not least.cases:
            yield Fault(f"no case rejects {name}: {_shown(each.maker)}", each.maker.file, remedy)
        elif least.cases < ENOUGH:
            what = f"{name}, {_shown(each.maker)}: no group rejects it in more than {least.cases} cases"
            yield Fault(what, each.maker.file, remedy)
        if not each.maker.text:
            yield Fault(f"nothing is said of {name!r}", each.maker.file, f"begin a table [{name}] in {FILE}")
    for group in words.spared:
        yield Fault(f"[{name}] says why {group!r} spares it, which is measured", catalogue, "remove it")


def _kills_measured(counted: Mapping[str, Sequence[_Counted]], problem: Problem) -> Kills:
    """The mistakes that each group rejects in enough cases of the pinned data."""
    return {
        group.name: {
            name
            for name, each in counted.items()
            if any(one.rejected.get(group.name, 0) >= ENOUGH for one in each)
        }
        for group in problem.groups
    }


def _aimed(problem: Problem) -> Mapping[str, Sequence[str]]:
    """The groups that should catch each mistake."""
    found: dict[str, list[str]] = {}
    for group in problem.groups:
        for name in group.kills:
            found.setdefault(name, []).append(group.name)
    return found


def _on_big_cases(maker: Maker, data: ProblemData, box_factory: BoxFactory) -> Behaviour:
    """What a choice answers wrongly in groups of big cases that name its mistake. Raises JudgeError."""
    problem = data.problem
    sized = [each for each in problem.groups if each.size is not None]
    big = [each.name for each in sized if maker.name in each.kills or not problem.in_toml]
    if not big:
        return {}
    settings = Settings(box_factory=box_factory, measured=False)
    source = maker.program.source
    return behaviour(run_submission(problem, data, source, "mistake.py", settings=settings, groups=big))


def _wrong_right_ways(family: Family, computer: Computer) -> Iterator[Fault]:
    for choice in family.right_ways():
        where = family.style_place(choice)
        does = computer.behaviour(Program(family.program(choice).encode(), where, trusted=True))
        failed = [name for name, answers in does.items() if answers.wrong]
        if failed:
            yield Fault(
                f"a right way is rejected by {', '.join(failed)}",
                where,
                "correct it, or write it as a mistake",
            )


class _Counted(Struct, frozen=True):
    """A program that makes a mistake, and in how many cases each group rejects it; others do not."""

    maker: Maker
    rejected: Mapping[str, int]  # of the pinned data
    seeds: tuple[Mapping[str, int], ...] = ()  # and of every seed

    @property
    def least(self) -> Least:
        """The fewest cases, over the seeds, of the group that rejects it most often there."""
        worst = min(self.seeds, key=lambda counts: max(counts.values(), default=0))
        group = max(worst, key=worst.__getitem__, default="")
        return Least(self.maker.name, _shown(self.maker), group, worst.get(group, 0))

    def most(self, groups: Iterable[str]) -> int:
        """The greatest number of one of these groups."""
        return max((self.rejected.get(name, 0) for name in groups), default=0)


def _told_apart(counted: Sequence[_Counted], family: Family) -> Sequence[_Counted]:
    """Those that are to be rejected. A change that is made in every problem alike may be no mistake in this
    one: it is left out where no case rejects it, and one does another that makes the same mistake.
    """
    if family.problem.in_toml and not any(each.rejected for each in counted):
        return counted
    return [
        each
        for each in counted
        if each.rejected or each.maker.choice is None or not family.general(each.maker.choice)
    ]


def _still_told(maker: Maker, rejected: Mapping[str, int]) -> Iterator[Fault]:
    if rejected:
        yield Fault(f"{maker.name} is said to be equal, and {next(iter(rejected))} rejects it", maker.file)


def _kills(
    name: str, counted: Sequence[_Counted], own: Sequence[str], words: Words, problem: Problem
) -> Iterator[Fault]:
    """What there is to say of the programs that make one mistake, and of the groups that name it."""
    for each in counted:
        if not each.rejected:
            remedy = "add a case that does, or say below it with '# !' why none can"
            yield Fault(f"no case rejects {name}: {_shown(each.maker)}", each.maker.file, remedy)
        elif own and each.most(own) < ENOUGH:
            listed = ", ".join(f"{group} {each.rejected.get(group, 0)}" for group in own)
            best = max(each.rejected, key=lambda group: each.rejected[group])
            few = f"its own groups reject it in few cases ({listed}), {best} in {each.rejected[best]}"
            remedy = f"strengthen their data, or let another group's kills name {name!r}"
            yield Fault(f"{name}, {_shown(each.maker)}: {few}", each.maker.file, remedy)
    for group in own if counted else ():
        yield from _of_group(group, name, counted, words.spared.get(group, ""), problem)
    for group in sorted(words.spared.keys() - set(own if counted else ())):
        what = f"[{name}] says why {group!r} spares some that make it, and that group names no such mistake"
        yield Fault(what, f"{problem.solutions.parent.name}/{FILE}", "remove it")


def _of_group(
    group: str, name: str, counted: Sequence[_Counted], why: str, problem: Problem
) -> Iterator[Fault]:
    """Whether a group that names a mistake rejects what makes it; `why` is the reason why not everything."""
    words = f"{problem.solutions.parent.name}/{FILE}"
    where = f"{problem.id}/problem.toml"
    remedy = "strengthen its data, or take the name out of its kills"
    most = max(each.most([group]) for each in counted)
    least = min(counted, key=lambda each: each.most([group]))
    few = least.most([group])
    if not most:
        yield Fault(f"group {group!r} names {name!r} and accepts every program that makes it", where, remedy)
    elif most < ENOUGH:
        what = f"group {group!r} names {name!r} and rejects no program that makes it in {ENOUGH} cases"
        yield Fault(what, where, remedy)
    elif few < ENOUGH and not why:
        place = f"{least.maker.file} ({_shown(least.maker)})"
        what = f"group {group!r} names {name!r} and rejects {place} in {few or 'no'} cases"
        yield Fault(what, where, f"{remedy}, or say why with spared.{group} in [{name}.in.{problem.id}]")
    elif few >= ENOUGH and why:
        what = f"[{name}] says why {group!r} spares some that make it, and it rejects them all"
        yield Fault(what, words, "remove it")


def _shown(maker: Maker) -> str:
    return maker.lines[0].wrong.partition("\n")[0] if maker.lines else maker.file


def _names(choices: Sequence[Maker], aimed: Mapping[str, Sequence[str]]) -> Iterator[Fault]:
    for name in sorted({maker.name for maker in choices}):
        first = next(maker for maker in choices if maker.name == name)
        if name not in aimed:
            yield Fault(f"no group's kills name {name!r}", first.file, "name it where it fails")
        if not first.text:
            yield Fault(f"nothing is said of {name!r}", first.file, f"begin a table [{name}] in {FILE}")
