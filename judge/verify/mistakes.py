"""The setter's gate for mistakes.py: every choice is rendered as a program and called on all cases.

    right ways    every right route, plain and in each of its styles, answers all cases rightly
    rejected      every mistake is rejected, unless the file says why no case can tell it; of the changes that
                  are made in every problem alike, one of a name at least
    enough        some group rejects it in five cases at least, on every seed

A mistake without a word in mistakes.toml is a fault too. Every rule of the statement, an item of the list
before `## Examples`, should have a mistake that ignores it and names its words: `# @ goes on for ever`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from operator import itemgetter

from msgspec import Struct
from msgspec.structs import replace

from judge.data import ProblemData
from judge.errors import ProblemError
from judge.mistakes.catalogue import EXAMPLE, FILE
from judge.mistakes.computed import Computer
from judge.mistakes.family import Family, Maker, read_makers
from judge.problem import Group, Problem
from judge.run.execute import judge_submission
from judge.run.settings import Settings
from judge.sandbox import BoxFactory
from judge.values.wire import cut
from judge.verify.model import ENOUGH, Fault, MistakeReport, Progress, fault_of

_CODE = re.compile(r"`|[=!<>]=|\*\*|//")  # signs of code in what is to be seen in the answers
_WITHOUT_CODE = f"say what is seen in the answers; what the code does begins with '{EXAMPLE}'"
_RULE = r"^- (.*(?:\n(?: .*)?$)*)"  # an item of a list, with the lines that go on below it
_SHOWN = 60  # characters of a rule in a message


class ChoicesReport(Struct, frozen=True):
    """What came of a problem's choices: what is wrong, what is worth a look, how each mistake is found."""

    faults: tuple[Fault, ...] = ()
    warnings: tuple[Fault, ...] = ()
    mistakes: tuple[MistakeReport, ...] = ()


def verify_choices(
    problem: Problem,
    data: Sequence[ProblemData],
    box_factory: BoxFactory,
    progress: Progress,
    *,
    partial: bool = False,
) -> ChoicesReport:
    """Check the problem's mistakes.py, where there is one, on its data: the pinned ones, then of other seeds.

    Where the data are but a `partial` set of groups, no mistake need be rejected.

    Raises JudgeError where nothing can be run.
    """
    read = read_makers(problem)
    where = f"{problem.solutions.name}/mistakes.py"
    faults = [fault_of(each, where) for each in read.faults]
    family = read.family
    if family is None:
        return ChoicesReport(tuple(faults))
    choices = [each for each in read.all if each.program.trusted and not each.offered]
    warnings: list[Fault] = []
    found: list[tuple[Maker, MistakeReport]] = []
    try:
        computers = [Computer(each) for each in data]
        for computer in computers:
            faults += _wrong_right_ways(family, computer)
        for done, maker in enumerate(choices):
            progress("judging mistakes", done, len(choices))
            seeds = [_rejected(maker, computer, data[0], box_factory) for computer in computers]
            if maker.equal and seeds[0]:
                what = f"{maker.name} is said to be equal, and {next(iter(seeds[0]))} rejects it"
                warnings.append(Fault(what, maker.file))
            # A change that is made in every problem alike may be no mistake in this one.
            elif not maker.equal and (seeds[0] or not maker.general):
                found.append((maker, _reported(maker, seeds)))
    except ProblemError as fault:
        faults.append(fault_of(fault, where))
    faults += [
        Fault(f"{maker.seen!r} of {maker.name} has signs of code", maker.file, _WITHOUT_CODE)
        for maker in choices
        if _CODE.search(maker.seen)
    ]
    untagged, unruled = _rule_faults(family)
    faults += untagged
    if not partial:
        faults += [fault for each in found for fault in _measured(*each)]
    mistakes = tuple(_by_name([row for _, row in found], problem.groups))
    return ChoicesReport(tuple(dict.fromkeys(faults)), (*warnings, *unruled), mistakes)


def _reported(maker: Maker, seeds: Sequence[Mapping[str, int]]) -> MistakeReport:
    """The fewest cases, over the seeds, of the group that rejects it most often there.

    Of every seed it is told in how many cases each group rejects it, of the pinned data first.
    """
    worst = min(seeds, key=lambda counts: max(counts.values(), default=0))
    group = max(worst, key=worst.__getitem__, default="")
    enough = tuple([name for name, cases in seeds[0].items() if cases >= ENOUGH])
    return MistakeReport(
        maker.name, maker.line.partition("\n")[0] or maker.file, group, worst.get(group, 0), enough
    )


def _by_name(rows: Sequence[MistakeReport], groups: Sequence[Group]) -> Iterator[MistakeReport]:
    """Of each mistake the program that is rejected least, with the groups that reject any."""
    weakest = {row.name: row for row in sorted(rows, key=lambda row: -row.cases)}
    rejecting = {(row.name, group) for row in rows for group in row.groups}
    for name, row in sorted(weakest.items()):
        yield replace(row, groups=tuple([each.name for each in groups if (name, each.name) in rejecting]))


def _rejected(maker: Maker, computer: Computer, data: ProblemData, box_factory: BoxFactory) -> dict[str, int]:
    """In how many cases of each group a mistake is rejected; groups that accept it are left out.

    Where other groups hardly reject it, big cases are tried; of what is made in every kata alike only where
    they do reject it. Raises JudgeError.
    """
    does = dict(computer.behaviour(maker.program))
    big = [each.name for each in data.problem.groups if each.size is not None]
    most = max((len(answers.wrong) for answers in does.values()), default=0)
    if big and maker.general <= most < ENOUGH:
        settings = Settings(box_factory=box_factory, measured=False)
        does |= judge_submission(data, maker.program.source, "mistake.py", settings, groups=big).behaviour
    return {name: len(answers.wrong) for name, answers in does.items() if answers.wrong}


def _measured(maker: Maker, found: MistakeReport) -> Iterator[Fault]:
    """Whether a program that makes a mistake is rejected in enough cases of some group, on each seed."""
    name, line, cases = found.name, found.line, found.cases
    remedy = "strengthen a group, or say below it with '# !' why none can"
    if not cases:
        yield Fault(f"no case rejects {name}: {line}", maker.file, remedy)
    elif cases < ENOUGH:
        what = f"{name}, {line}: no group rejects it in more than {cases} cases"
        yield Fault(what, maker.file, remedy)
    if not maker.text:
        yield Fault(f"nothing is said of {name!r}", maker.file, f"begin a table [{name}] in {FILE}")


def _wrong_right_ways(family: Family, computer: Computer) -> Iterator[Fault]:
    for right in family.right_ways():
        does = computer.behaviour(right.program)
        if failed := [name for name, answers in does.items() if answers.wrong]:
            what = f"a right way is rejected by {', '.join(failed)}"
            yield Fault(what, right.file, "correct it, or write it as a mistake")


# -- the rules of the statement -----------------------------------------------------------------------------


def rules_of(statement: str) -> list[str]:
    """The rules of a statement's text, each in one line."""
    text = statement.partition("\n## Examples")[0]
    return [" ".join(rule.split()) for rule in re.findall(_RULE, text, re.MULTILINE)]


def _rule_faults(family: Family) -> tuple[list[Fault], list[Fault]]:
    """The changes that name no rule or more than one, and as warnings the rules that no change ignores."""
    rules = rules_of(family.problem.statement)
    changes = [change for route in family.routes for change in route.changes if not change.equal]
    tags = {(words, change.line) for change in changes for words in change.rules}
    faults = []
    for words, line in sorted(tags, key=itemgetter(1)):
        if (count := sum(words in rule for rule in rules)) != 1:
            what = f"{f'{count} rules have' if count else 'no rule has'} the words {words!r}"
            faults.append(Fault(what, f"{family.where}:{line}", "write words that stand in one rule"))
    remedy = (
        f"write the mistake that ignores it in {family.where}, with '# @ ' and some of its words below it"
    )
    where = f"{family.problem.id}/statement.md"
    return faults, [
        Fault(f"no mistake ignores the rule {cut(rule, _SHOWN)!r}", where, remedy)
        for rule in rules
        if not any(words in rule for words, _ in tags)
    ]
