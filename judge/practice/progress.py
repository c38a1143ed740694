"""What a person has shown: katas solved, levels and skills passed, questions of the checklist answered.

A run covers the test groups that it passed. The groups of one problem that show a skill are a need, met by
one run that passed all of them; a skill is shown once one of its needs was met: who can do it in one problem
can do it. It is lost where the latest run that tried a need that was met fails it. A run that passed no test
group at all loses nothing. A run of groups that the problem no longer has keeps the levels that it recorded.

A question is ticked by any one of these, whole; it is lost where one of them was whole, and none is any more:

    katas     each of them that is here was accepted
    skills    each of them that is here is shown
    cards     each card that names the question was remembered when it was last answered
    broken    one of these mistakes was broken with a case of the person's own (`judge hack`)

A wrong program is broken by a case that keeps the promise and that it answers wrongly; by the case that was
shown to whoever gave it up, it is not.
"""

from __future__ import annotations

import contextlib
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from enum import Enum
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.errors import StoreError
from judge.practice.events import Answer, Hack, Outcome, Run
from judge.practice.syllabus import Checklist, Row, Skill
from judge.problem import Problem
from judge.problem.model import KataLevel, Listed

if TYPE_CHECKING:
    from judge.practice.cards import Card


Tried = Mapping[str, Sequence[Run]]  # a person's runs by problem, as `tried` gives them


class State(Enum):
    """How far a skill or a question has come; the value is its name in JSON."""

    OPEN = "open"
    SHOWN = "shown"
    LOST = "lost"


class Covered(Struct, frozen=True):
    """Test groups of one problem: the most that one run passed, and when one first passed all of them.

    `failing` are those that the latest run to try them fails. `attempts` are the runs that tried them, up to
    the first that passed all; `mistakes` are those of the groups that were made, and how often.
    """

    problem: str
    groups: tuple[str, ...]
    level: KataLevel | None = None
    best: int = 0
    since: datetime | None = None
    failing: tuple[str, ...] = ()
    attempts: int = 0
    mistakes: dict[str, int] = {}

    @property
    def lost(self) -> bool:
        """Whether all were passed once, and no longer are."""
        return self.since is not None and bool(self.failing)


class SkillProgress(Struct, frozen=True):
    """One skill: since when it is shown, and how each of its needs stands.

    `attempts` are the runs that it took on the problem where it was first shown, or has taken so far on all;
    `mistakes` are those that stood in its way, and how often.
    """

    name: str
    about: str
    state: State
    since: datetime | None
    attempts: int
    mistakes: dict[str, int]
    needs: tuple[Covered, ...]

    @property
    def met(self) -> int:
        """How many of the needs were met."""
        return sum(need.since is not None for need in self.needs)


class Kind(Enum):
    """What ticks a question; the value is its name in JSON."""

    KATA = "kata"
    SKILL = "skill"
    CARD = "card"
    BROKEN = "broken"


class Evidence(Struct, frozen=True):
    """One thing that may tick a question: since when it does, and whether it did and no longer does.

    `drill` are the words of the command that practises it.
    """

    kind: Kind
    name: str
    drill: str
    since: datetime | None = None
    lost: bool = False


class Question(Struct, frozen=True):
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
    found: dict[str, list[Run]] = {}
    for run in runs:
        if run.counts:
            found.setdefault(run.problem, []).append(run)
    return found


def solved(runs: Sequence[Run]) -> dict[str, datetime]:
    """The problems that the person has solved, and when first; the runs are in their order."""
    return {run.problem: run.when for run in reversed(runs) if run.solved}


def mistakes(runs: Iterable[Run]) -> Counter[str]:
    """The mistakes that explained the runs, one or two each, and how often."""
    return Counter(name for run in runs if run.mistake for name in run.mistake.split(" + "))


def levels(problems: Iterable[Listed], own: Tried) -> list[Covered]:
    """How each level of these problems stands after a person's `own` runs."""
    found = []
    for problem in problems:
        runs = own.get(problem.id, ())
        recorded = [_recorded(run, problem) for run in runs]
        for level in problem.levels:
            groups = tuple(group.name for group in problem.of_level(level))
            whole = zip(runs, [level.value in each for each in recorded], strict=True)
            found.append(_covered(problem.id, groups, whole, level=level))
    return found


def stars(levels: Iterable[Covered]) -> Counter[str]:
    """Of each problem: 1 once its interview level is passed, 2 with production."""
    return Counter(level.problem for level in levels if level.since)


def skills(problems: Iterable[Problem], own: Tried, named: Iterable[Skill]) -> list[SkillProgress]:
    """How each of these skills that the problems show stands after a person's `own` runs."""
    needs: defaultdict[str, list[Covered]] = defaultdict(list)
    for problem in problems:
        runs = [(run, False) for run in own.get(problem.id, ())]
        for shown in problem.skills:
            kills = {name for group in problem.groups if group.name in shown.groups for name in group.kills}
            needs[shown.name].append(_covered(problem.id, shown.groups, runs, kills))
    return [_skill(each, needs[each.name]) for each in named if each.name in needs]


def _recorded(run: Run, problem: Listed) -> Collection[str]:
    """The levels that a run passed whole, whatever groups the problem has today."""
    if run.solved:
        return [level.value for level in problem.levels]
    if not {group.name for group in problem.groups}.issuperset(run.passed + run.failed):
        with contextlib.suppress(StoreError):
            return run.levels
    return ()


def _covered(
    problem: str,
    groups: tuple[str, ...],
    runs: Iterable[tuple[Run, bool]],
    kills: Collection[str] = (),
    level: KataLevel | None = None,
) -> Covered:
    """How the groups stand after the problem's runs, each with whether it is known to have passed them all.

    `kills` are the mistakes that the groups reject.
    """
    since: datetime | None = None
    wanted, failing = frozenset(groups), frozenset[str]()
    best = attempts = 0
    made: Counter[str] = Counter()
    for run, whole in runs:
        passes = wanted if whole else wanted.intersection(run.passed)
        fails = frozenset[str]() if whole else wanted.intersection(run.failed)
        if not passes and not fails:  # it was judged on other groups only
            continue
        attempts += since is None
        best = max(best, len(passes))
        if run.passed:  # a file that is begun anew passes nothing yet, and takes nothing away
            failing = fails
        if since is None and passes == wanted:
            since = run.when
        if fails:
            made.update({name: times for name, times in mistakes([run]).items() if name in kills})
    lost = tuple(group for group in groups if group in failing)
    return Covered(problem, groups, level, best, since, lost, attempts, made)


def _skill(skill: Skill, needs: Sequence[Covered]) -> SkillProgress:
    since, attempts = min(((need.since, need.attempts) for need in needs if need.since), default=(None, 0))
    made = sum((Counter(need.mistakes) for need in needs), Counter[str]())
    return SkillProgress(
        skill.name,
        skill.about,
        State.LOST if any(need.lost for need in needs) else State.SHOWN if since else State.OPEN,
        since,
        attempts or sum(need.attempts for need in needs),
        dict(made.most_common()),
        tuple(needs),
    )


# -- questions ---------------------------------------------------------------------------------------------


def questions(
    problems: Iterable[Problem],
    done: Mapping[str, datetime],
    skilled: Iterable[SkillProgress],
    checklist: Checklist,
    cards: Iterable[Card] = (),
    answers: Sequence[Answer] = (),
    hacks: Iterable[Hack] = (),
) -> list[Question]:
    """The questions by section, after `done`, the problems solved, and `skilled`, how all skills stand.

    Answers and attempts at wrong programs are oldest first.
    """
    here = {problem.id for problem in problems}
    by_name = {skill.name: skill for skill in skilled}
    there = [card for card in cards if not card.problem or card.problem in here]
    known = {answer.card: answer.when for answer in reversed(answers) if answer.known}  # first
    last = {answer.card: answer for answer in answers}
    won = broken(hacks)

    def evidence(row: Row) -> Iterator[Evidence]:
        for kata in row.katas:
            if kata in here:
                yield Evidence(Kind.KATA, kata, f"judge start {kata}", done.get(kata))
        for skill in (by_name[name] for name in row.skills if name in by_name):
            needs = sorted(skill.needs, key=lambda need: need.since is not None and not need.lost)
            drill, lost = f"judge start {needs[0].problem}", skill.state is State.LOST
            yield Evidence(Kind.SKILL, skill.name, drill, skill.since, lost)
        for key in (card.key for card in there if row.id in card.rows):
            lost = key in known and not last[key].known
            yield Evidence(Kind.CARD, key, f"judge quiz --question {row.id}", known.get(key), lost)
        for name in row.broken:
            kata, mistake = name.split("/")
            if name in won or kata in here:
                yield Evidence(Kind.BROKEN, name, f"judge hack {kata} {mistake}", won.get(name))

    found = []
    for part in checklist.sections:
        for row in (row for row in checklist.rows if row.section == part.id):
            by = tuple(evidence(row))
            since = _ticked(by)
            state = State.SHOWN if since else State.LOST if any(each.lost for each in by) else State.OPEN
            found.append(Question(row.id, part.title, row.ask, state, since, by))
    return found


def _ticked(by: Iterable[Evidence]) -> datetime | None:
    """Since when: all of one kind tick it, or one mistake that was broken."""
    dates: list[datetime] = []
    for kind in Kind:
        own = [None if each.lost else each.since for each in by if each.kind is kind]
        there = [date for date in own if date]
        if kind is Kind.BROKEN:
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


class HackShare(Struct, frozen=True):
    """Of a problem's `programs` wrong ones, those that were broken: by mistake, when it was done first."""

    problem: str
    programs: int
    broken: Mapping[str, datetime]


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
    return any(
        hack.outcome is Outcome.GIVEN_UP and (hack.mistake, hack.case) == (mistake, case) for hack in hacks
    )


def hack_states(mistakes: Iterable[str], hacks: Sequence[Hack]) -> dict[str, HackState]:
    """How the program of each of one problem's mistakes stands."""
    states = {hack.mistake: HackState.GIVEN_UP for hack in hacks if hack.outcome is Outcome.GIVEN_UP}
    states |= {name.partition("/")[2]: HackState.BROKEN for name in broken(hacks)}
    return {name: states.get(name, HackState.OPEN) for name in mistakes}


def hack_shares(problems: Iterable[Problem], hacks: Sequence[Hack]) -> list[HackShare]:
    """The share of each of these problems that was tried; the mistakes of no other are read.

    Raises ProblemError where the files that tell of a problem's mistakes are broken.
    """
    from judge.mistakes.puzzles import read_puzzles  # most people's history has no attempt

    named, won, found = {hack.problem for hack in hacks}, broken(hacks), []
    for problem in problems:
        if problem.id in named:
            known = {f"{problem.id}/{puzzle.mistake}": puzzle.mistake for puzzle in read_puzzles(problem)}
            own = {known[name]: when for name, when in won.items() if name in known}
            found.append(HackShare(problem.id, len(known), own))
    return found
