"""What a person has shown: katas solved, levels and skills passed, questions of the checklist answered.

A run covers the test groups that it passed. The groups of one problem that show a skill are a need, met by
one run that passed all of them; a skill is shown once one of its needs was met: who can do it in one problem
can do it. It is lost where the latest run that tried a need that was met fails it. A run that passed no test
group at all loses nothing. A run of groups that the problem no longer has keeps the levels that it recorded.

A question is ticked by any one of these, whole; it is lost where one of them was whole, and none is any more:

    katas     each of them that is here was accepted
    skills    each of them that is here is shown
    cards     each card that names the question was remembered when it was last answered
    broken    one of these mistakes was broken with a case of the person's own
"""

from __future__ import annotations

import contextlib
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from msgspec import Struct

from judge.errors import ProblemError, StoreError
from judge.practice.checklist import Checklist, Row, Section, read_checklist
from judge.practice.events import Answer, Hack, Run
from judge.practice.hacks import broken
from judge.problem import Problem
from judge.problem.model import KataLevel

if TYPE_CHECKING:
    from judge.practice.history import History
    from judge.practice.quiz.cards import Card


class State(Enum):
    """How far a skill or a question has come; the value is its name in JSON."""

    OPEN = "open"
    SHOWN = "shown"
    LOST = "lost"


class Standing(Struct, frozen=True):
    """One problem's runs in short.

    `attempts` are the runs up to the first that solved it, that one included, or all of them where none did.
    `best` is the highest score.
    """

    attempts: int = 0
    best: int = 0
    passed: datetime | None = None  # first
    last: datetime | None = None


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


class Progress(Struct, frozen=True):
    """How a person stands; `mistakes` are those made in each problem, and how often."""

    standings: Mapping[str, Standing]
    levels: tuple[Covered, ...]
    skills: tuple[SkillProgress, ...]
    sections: tuple[tuple[Section, tuple[Question, ...]], ...] = ()
    mistakes: Mapping[str, Counter[str]] = {}

    def within(self, problems: Collection[str]) -> Progress:
        """The same of these problems alone; all questions stay."""
        needs = [(each, tuple(n for n in each.needs if n.problem in problems)) for each in self.skills]
        return Progress(
            {name: standing for name, standing in self.standings.items() if name in problems},
            tuple(level for level in self.levels if level.problem in problems),
            tuple(_skill(each.name, each.about, own) for each, own in needs if own),
            self.sections,
            {name: made for name, made in self.mistakes.items() if name in problems},
        )

    def solved(self, problem: str) -> bool:
        """Whether the person has solved the problem."""
        return self.standings.get(problem, Standing()).passed is not None

    def stars(self, problem: str) -> int:
        """1 once the problem's interview level is passed, 2 with production."""
        passed = [level.since is not None for level in self.levels if level.problem == problem]
        return len(passed) if self.solved(problem) else sum(passed)


def standings(runs: Iterable[Run]) -> dict[str, Standing]:
    """The standing of every problem that the person tried; `runs` are in their order."""
    found: dict[str, Standing] = {}
    for run in runs:
        if run.counts:
            before = found.get(run.problem, Standing())
            found[run.problem] = Standing(
                before.attempts + (before.passed is None),
                max(before.best, run.score),
                before.passed or (run.when if run.solved else None),
                run.when,
            )
    return found


def read_progress(
    history: History, problems: Sequence[Problem], extra: Sequence[Path]
) -> tuple[Progress, list[ProblemError]]:
    """How a person stands by a history, and the faults of decks, which are left out.

    `problems` are all that can be found. Raises ProblemError where a file of skills or questions is broken,
    StoreError.
    """
    from judge.practice.quiz.cards import read_decks

    decks, faults = read_decks(extra)
    cards = [card for deck in decks for card in deck.cards]
    answers, hacks = history.events(Answer), history.events(Hack)
    return assess(problems, history.runs(), read_checklist(extra), cards, answers, hacks), faults


def assess(
    problems: Sequence[Problem],
    runs: Sequence[Run],
    checklist: Checklist,
    cards: Iterable[Card] = (),
    answers: Iterable[Answer] = (),
    hacks: Iterable[Hack] = (),
) -> Progress:
    """How a person stands after these runs, answers and attempts at wrong programs, which are in their order.

    `problems` are all that can be found, `cards` likewise.
    """
    tries = {problem.id: _tries(problem, runs) for problem in problems}
    needs: defaultdict[str, list[Covered]] = defaultdict(list)
    for problem in problems:
        for shown in problem.skills:
            kills = {name for group in problem.groups if group.name in shown.groups for name in group.kills}
            needs[shown.name].append(_covered(problem.id, shown.groups, tries[problem.id], kills))
    named = [each for each in checklist.skills if each.name in needs]
    skills = tuple(_skill(each.name, each.about, tuple(needs[each.name])) for each in named)
    made: defaultdict[str, Counter[str]] = defaultdict(Counter)
    for run in runs:
        if run.counts:
            made[run.problem].update(_mistakes(run))
    found = standings(runs)
    katas = {
        each.id: Evidence(Kind.KATA, each.id, f"judge start {each.id}", found.get(each.id, Standing()).passed)
        for each in problems
    }
    skilled = {each.name: _of_skill(each) for each in skills}
    carded = _of_cards((card for card in cards if not card.problem or card.problem in katas), answers)
    attempts = tuple(hacks)

    def question(row: Row, title: str) -> Question:
        by = [katas[name] for name in row.katas if name in katas]
        by += [skilled[name] for name in row.skills if name in skilled]
        by += carded[row.id]
        return _question(row, title, (*by, *_of_hacks(row, attempts, katas)))

    sections = []
    for part in checklist.sections:
        its = tuple(question(row, part.title) for row in checklist.rows if row.section == part.id)
        sections += [(part, its)] if its else []
    levels = tuple(level for problem in problems for level in _levels(problem, tries[problem.id]))
    return Progress(found, levels, skills, tuple(sections), made)


class _Tried(NamedTuple):
    """A run with its test groups as sets; `levels` are those that it passed as its own row records."""

    run: Run
    passed: frozenset[str]
    failed: frozenset[str]
    levels: Collection[str]


def _tries(problem: Problem, runs: Iterable[Run]) -> list[_Tried]:
    """The runs of the problem that say something of the person."""
    today = {group.name for group in problem.groups}
    found = []
    for run in runs:
        if run.problem == problem.id and run.counts and (run.passed or run.failed):
            recorded: Collection[str] = ()
            if run.solved:
                recorded = [level.value for level in KataLevel]
            elif not today.issuperset(run.passed + run.failed):
                with contextlib.suppress(StoreError):
                    recorded = run.levels
            found.append(_Tried(run, frozenset(run.passed), frozenset(run.failed), recorded))
    return found


def _levels(problem: Problem, tries: Sequence[_Tried]) -> Iterator[Covered]:
    """Each level of the problem, the easier first."""
    for level in problem.levels:
        groups = tuple(group.name for group in problem.of_level(level))
        whole = frozenset(groups)
        its = [
            each._replace(passed=whole, failed=frozenset()) if level.value in each.levels else each
            for each in tries
        ]
        yield _covered(problem.id, groups, its, (), level)


def _covered(
    problem: str,
    groups: tuple[str, ...],
    tries: Iterable[_Tried],
    mistakes: Collection[str],
    level: KataLevel | None = None,
) -> Covered:
    wanted = frozenset(groups)
    since: datetime | None = None
    failing: frozenset[str] = frozenset()
    best = attempts = 0
    made: Counter[str] = Counter()
    for run, passed, failed, _ in tries:
        passes, fails = wanted & passed, wanted & failed
        if not passes and not fails:  # it was judged on other groups only
            continue
        attempts += since is None
        best = max(best, len(passes))
        if run.passed:  # a file that is begun anew passes nothing yet, and takes nothing away
            failing = fails
        if since is None and passes == wanted:
            since = run.when
        if fails:
            made.update(name for name in _mistakes(run) if name in mistakes)
    lost = tuple(group for group in groups if group in failing)
    return Covered(problem, groups, level, best, since, lost, attempts, made)


def _mistakes(run: Run) -> list[str]:
    """The mistakes that explained the run, none, one or two."""
    return run.mistake.split(" + ") if run.mistake else []


def _skill(name: str, about: str, needs: tuple[Covered, ...]) -> SkillProgress:
    since = min((need.since for need in needs if need.since is not None), default=None)
    firsts = [need.attempts for need in needs if since and need.since == since]
    lost = any(need.lost for need in needs)
    return SkillProgress(
        name,
        about,
        State.LOST if lost else State.SHOWN if since else State.OPEN,
        since,
        firsts[0] if firsts else sum(need.attempts for need in needs),
        dict(sum((Counter(need.mistakes) for need in needs), Counter[str]()).most_common()),
        needs,
    )


def _question(row: Row, section: str, by: tuple[Evidence, ...]) -> Question:
    """The question: ticked by all of one kind, or by one mistake that was broken."""
    dates = []
    for kind in Kind:
        own = [None if each.lost else each.since for each in by if each.kind is kind]
        there = [date for date in own if date is not None]
        if there and (kind is Kind.BROKEN or len(there) == len(own)):
            dates.append(min(there) if kind is Kind.BROKEN else max(there))
    since = min(dates, default=None)
    lost = any(each.lost for each in by)
    state = State.SHOWN if since else State.LOST if lost else State.OPEN
    return Question(row.id, section, row.ask, state, since, by)


def _of_skill(skill: SkillProgress) -> Evidence:
    needs = skill.needs
    drilled = next((need.problem for need in needs if need.since is None or need.lost), needs[0].problem)
    return Evidence(Kind.SKILL, skill.name, f"judge start {drilled}", skill.since, skill.state is State.LOST)


def _of_hacks(row: Row, hacks: Iterable[Hack], problems: Collection[str]) -> Iterator[Evidence]:
    """What the wrong programs show that a question names, of katas that are here or were broken before."""
    for name in row.broken:
        problem, mistake = name.split("/")
        when = broken(hack for hack in hacks if hack.problem == problem).get(mistake)
        if when or problem in problems:
            yield Evidence(Kind.BROKEN, name, f"judge hack {problem} {mistake}", when)


def _of_cards(cards: Iterable[Card], answers: Iterable[Answer]) -> Mapping[str, list[Evidence]]:
    """What cards show, by the id of each question that they practise."""
    given: defaultdict[str, list[Answer]] = defaultdict(list)
    for answer in answers:
        given[answer.card].append(answer)
    found: defaultdict[str, list[Evidence]] = defaultdict(list)
    for card in cards:
        known = next((answer.when for answer in given[card.key] if answer.known), None)
        lost = known is not None and not given[card.key][-1].known
        for row in card.rows:
            found[row].append(Evidence(Kind.CARD, card.key, f"judge quiz --question {row}", known, lost))
    return found
