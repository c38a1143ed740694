"""What a person has shown: katas solved, levels and skills passed, questions of the checklist answered.

A run covers the test groups that it passed. The groups of one problem that show a skill are a need, met by
one run that passed all of them; a skill is shown once one of its needs was met: who can do it in one problem
can do it. It is lost where the latest run that tried a need that was met fails it. A run that passed no test
group at all loses nothing.

A question is ticked by any one of these, whole; it is lost where one of them was whole, and none is any more:

    katas     each of them that is here was accepted
    skills    each of them that is here is shown
    cards     each card that names the question was remembered when it was last answered
    broken    one of these mistakes was broken with a case of the person's own (`judge hack`)

A wrong program is broken by a case that keeps the promise and that it answers wrongly; by the case that was
shown to whoever gave it up, it is not.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from enum import Enum
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.practice.events import Hack, Outcome, Run, grouped
from judge.practice.syllabus import Checklist, ChecklistRow, Skill
from judge.problem import Problem
from judge.problem.model import KataLevel, Listed

if TYPE_CHECKING:
    from judge.practice.cards import Card
    from judge.practice.review import Learner


Tried = Mapping[str, Sequence[Run]]  # a person's runs by problem, as `tried` gives them


class State(Enum):
    """How far a skill or a question has come; the value is its name in JSON."""

    OPEN = "open"
    SHOWN = "shown"
    LOST = "lost"


class Need(Struct, frozen=True):
    """The groups of one problem that show a skill: since when, and which the latest run fails after that."""

    problem: str
    groups: tuple[str, ...]
    since: datetime | None = None
    failing: tuple[str, ...] = ()


class SkillProgress(Struct, frozen=True):
    """One skill: since when it is shown, and how each of its needs stands."""

    name: str
    about: str
    state: State
    since: datetime | None
    needs: tuple[Need, ...]


class EvidenceKind(Enum):
    """What ticks a question; the value is its name in JSON."""

    KATA = "kata"
    SKILL = "skill"
    CARD = "card"
    BROKEN = "broken"


class Evidence(Struct, frozen=True):
    """One thing that may tick a question: since when it does, and whether it did and no longer does.

    `drill` are the words of the command that practises it.
    """

    kind: EvidenceKind
    name: str
    drill: str
    since: datetime | None = None
    lost: bool = False


class ChecklistQuestion(Struct, frozen=True):
    """A question of the checklist: its id (`row`), the title of its section, and what may tick it (`by`).

    `since` says since when it has been ticked; only what is here is in `by`.
    """

    row: str
    section: str
    ask: str
    state: State
    since: datetime | None
    by: tuple[Evidence, ...]

    @property
    def drills(self) -> tuple[str, ...]:
        """The commands that practise it, what does not tick it yet first; each once."""
        waiting = sorted(self.by, key=lambda each: each.since is not None and not each.lost)
        return tuple(dict.fromkeys(each.drill for each in waiting))


# -- katas, levels and skills ------------------------------------------------------------------------------


def tried(runs: Iterable[Run]) -> dict[str, list[Run]]:
    """The runs that say something of the person, by problem, in their order."""
    return grouped((run for run in runs if run.counts), lambda run: run.problem)


def solved(runs: Sequence[Run]) -> dict[str, datetime]:
    """The problems that the person has solved, and when first; the runs are in their order."""
    return {run.problem: run.when for run in reversed(runs) if run.solved}


def mistakes(runs: Iterable[Run]) -> Counter[str]:
    """The mistakes that explained the runs, one or two each, and how often."""
    return Counter(name for run in runs if run.mistake for name in run.mistake.split(" + "))


def levels_passed(problem: Listed, runs: Iterable[Run]) -> list[KataLevel]:
    """The levels of a problem that one of its runs passed whole; its stars are their number."""
    groups = {level: {group.name for group in problem.of_level(level)} for level in problem.levels}
    return [level for level in groups if any(run.solved or groups[level] <= {*run.passed} for run in runs)]


def skills(problems: Iterable[Problem], own: Tried, named: Iterable[Skill]) -> list[SkillProgress]:
    """How each of these skills that the problems show stands after a person's `own` runs."""
    needs: defaultdict[str, list[Need]] = defaultdict(list)
    for problem in problems:
        for shown in problem.skills:
            needs[shown.name].append(_need(problem.id, shown.groups, own.get(problem.id, ())))
    return [_skill(each, needs[each.name]) for each in named if each.name in needs]


def _need(problem: str, groups: tuple[str, ...], runs: Iterable[Run]) -> Need:
    """How the groups stand after the problem's runs; one that was judged on others only says nothing."""
    wanted, failing, since = frozenset(groups), frozenset[str](), None
    for run in runs:
        fails = wanted.intersection(run.failed)
        if since is None and wanted.issubset(run.passed):
            since = run.when
        # a file that is begun anew passes nothing yet, and takes nothing away
        if run.passed and (fails or not wanted.isdisjoint(run.passed)):
            failing = fails
    return Need(problem, groups, since, tuple(group for group in groups if since and group in failing))


def _skill(skill: Skill, needs: Sequence[Need]) -> SkillProgress:
    since = min((need.since for need in needs if need.since), default=None)
    state = State.LOST if any(need.failing for need in needs) else State.SHOWN if since else State.OPEN
    return SkillProgress(skill.name, skill.about, state, since, tuple(needs))


# -- questions ---------------------------------------------------------------------------------------------


def questions(
    mine: Learner, skilled: list[SkillProgress], checklist: Checklist, cards: list[Card], hacks: list[Hack]
) -> list[ChecklistQuestion]:
    """The questions by section, after `skilled`, how all skills stand, and `hacks`, the oldest first."""
    here = {problem.id for problem in mine.problems}
    by_name = {skill.name: skill for skill in skilled}
    there = [card for card in cards if not card.problem or card.problem in here]
    known = {answer.card: answer.when for answer in reversed(mine.answers) if answer.known}  # first
    last = {answer.card: answer for answer in mine.answers}
    won = broken(hacks)

    def evidence(row: ChecklistRow) -> Iterator[Evidence]:
        for kata in row.katas:
            if kata in here:
                yield Evidence(EvidenceKind.KATA, kata, f"judge start {kata}", mine.solved.get(kata))
        for skill in (by_name[name] for name in row.skills if name in by_name):
            needs = sorted(skill.needs, key=lambda need: need.since is not None and not need.failing)
            drill, lost = f"judge start {needs[0].problem}", skill.state is State.LOST
            yield Evidence(EvidenceKind.SKILL, skill.name, drill, skill.since, lost)
        quiz = " ".join(("judge quiz", *checklist.topics(row.skills)[:1]))
        for key in (card.key for card in there if row.id in card.content.rows):
            lost = key in known and not last[key].known
            yield Evidence(EvidenceKind.CARD, key, quiz, known.get(key), lost)
        for name in row.broken:
            kata, mistake = name.split("/")
            if name in won or kata in here:
                yield Evidence(EvidenceKind.BROKEN, name, f"judge hack {kata} {mistake}", won.get(name))

    found = []
    for part in checklist.sections:
        for row in (row for row in checklist.rows if row.section == part.id):
            by = tuple(evidence(row))
            since = _ticked(by)
            state = State.SHOWN if since else State.LOST if any(each.lost for each in by) else State.OPEN
            found.append(ChecklistQuestion(row.id, part.title, row.ask, state, since, by))
    return found


def _ticked(by: Iterable[Evidence]) -> datetime | None:
    """Since when: all of one kind tick it, or one mistake that was broken."""
    dates: list[datetime] = []
    for kind in EvidenceKind:
        own = [None if each.lost else each.since for each in by if each.kind is kind]
        there = [date for date in own if date]
        if kind is EvidenceKind.BROKEN:
            dates += there
        elif there and len(there) == len(own):
            dates.append(max(there))
    return min(dates, default=None)


# -- wrong programs ----------------------------------------------------------------------------------------


class HackState(Enum):
    """How a wrong program stands; the value is its name in JSON."""

    OPEN = "open"
    BROKEN = "broken"
    GIVEN_UP = "given-up"


def broken(hacks: Iterable[Hack]) -> dict[str, datetime]:
    """The programs that were broken, as "problem/mistake", and when first; the attempts are in order."""
    found: dict[str, datetime] = {}
    shown = set()
    for hack in hacks:
        name = f"{hack.problem}/{hack.mistake}"
        if hack.outcome is Outcome.GIVEN_UP:
            shown.add((name, hack.case))
        elif hack.outcome is Outcome.WON and (name, hack.case) not in shown:
            found.setdefault(name, hack.when)
    return found


def was_shown(mistake: str, case: str, hacks: Iterable[Hack]) -> bool:
    """Whether the case was shown to whoever gave up that mistake of one problem."""
    given_up = Outcome.GIVEN_UP, mistake, case
    return any((hack.outcome, hack.mistake, hack.case) == given_up for hack in hacks)


def hack_states(mistakes: Iterable[str], hacks: Sequence[Hack]) -> dict[str, HackState]:
    """How the program of each of one problem's mistakes stands."""
    states = {hack.mistake: HackState.GIVEN_UP for hack in hacks if hack.outcome is Outcome.GIVEN_UP}
    states |= {name.partition("/")[2]: HackState.BROKEN for name in broken(hacks)}
    return {name: states.get(name, HackState.OPEN) for name in mistakes}
