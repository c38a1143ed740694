"""Which cards are asked next, what to practise afterwards, and the mock interview: cards, a kata, cards."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.practice.cards import Card, read_decks
from judge.practice.progress import State, skills
from judge.practice.review import Learner, Review, card_reviews, read_learner
from judge.practice.syllabus import SETS, Checklist, read_checklist
from judge.problem import Problem, Verdict
from judge.problem.find import problem_folders
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.practice.history import History

_BEFORE, _AFTER = 6, 15  # minutes of the interview for each card before the kata, and after it


class Practise(Struct, frozen=True):
    """A question of the checklist to practise, and the commands that do."""

    question: str
    ask: str
    commands: tuple[str, ...]


class Topic(Struct, frozen=True):
    """Skills that are drilled together: all of them, those that are not known yet, and what practises those.

    A skill is known if the last run that tests it shows it, and its last card was right. `weak` are the keys
    of the open skills' cards.
    """

    name: str
    skills: tuple[str, ...]
    open: tuple[str, ...]
    weak: tuple[str, ...]


def topics(mine: Learner, cards: Sequence[Card], checklist: Checklist) -> list[Topic]:
    """How every topic stands."""
    every = skills(mine.problems, mine.own, checklist.skills)
    shown = {each.name for each in every if each.state is State.SHOWN}
    last = {answer.card: answer for answer in mine.answers}
    found = []
    for name in sorted({each.topic for each in checklist.skills if each.topic}):
        own = [each.name for each in checklist.skills if each.topic == name]
        open_ = []
        for skill in own:
            keys = [card.key for card in cards if skill in card.skills]
            latest = max((last[key] for key in keys if key in last), key=lambda each: each.when, default=None)
            if skill not in shown or (keys and not (latest and latest.known)):
                open_.append(skill)
        weak = (card.key for card in cards if not {*open_}.isdisjoint(card.skills))
        found.append(Topic(name, tuple(own), tuple(open_), tuple(weak)))
    return found


def near_sets(own: str) -> tuple[str, ...]:
    """That set, the one below and the one above."""
    if own not in SETS:
        return (own,)
    at = SETS.index(own)
    return (own, *SETS[max(at - 1, 0) : at], *SETS[at + 1 : at + 2])


class Wanted:
    """What a person is asked next: the set that was named or the own one, those near it, how topics stand.

    `name` is the set that was named; `cards` are those of all decks.
    """

    def __init__(self, name: str, mine: Learner, cards: Sequence[Card], checklist: Checklist) -> None:
        self.mine, self.checklist = mine, checklist
        self.answered = card_reviews(mine.answers)
        self.own = next(iter(mine.from_own(name)), None)
        self.near = near_sets(self.own.name if self.own else "")
        self.topics = topics(mine, cards, checklist)

    def of(self, cards: Sequence[Card], now: datetime, count: int, *, ahead: bool = False) -> list[Card]:
        """These cards in their turn: due ones, the longest overdue first, then new ones.

        If `count` are asked, half of their new ones are of what is open, one topic after the other; half are
        of the own set. Both are of the sets near it while there are any. With `ahead` those follow that are
        due later.
        """
        by_key = {card.key: card for card in cards}
        known = [each for each in self.answered if each.name in by_key]
        due = [by_key[each.name] for each in known if each.is_due(now)]
        answered = {each.name for each in known}
        new = [card for card in cards if card.key not in answered]
        close = [card for card in new if not {*self.near}.isdisjoint(card.sets)]
        turns = zip_longest(*([card for card in close if card.key in each.weak] for each in self.topics))
        topical = {card.key: card for turn in turns for card in turn if card}
        own = sorted(close, key=lambda card: self.near[0] not in card.sets)
        later = [by_key[each.name] for each in known] if ahead else []
        half = max(count - len(due) + 1, 0) // 2
        chosen = (*due, *[*topical.values()][:half], *own, *new, *later)
        return list({card.key: card for card in chosen}.values())


def read_wanted(name: str, history: History, extra: Sequence[Path] = ()) -> Wanted:
    """The same of what a history says of a person. Raises StoreError, and ProblemError as read_checklist."""
    return Wanted(name, read_learner(history, extra), read_decks(extra)[0], read_checklist(extra))


def next_due(cards: Iterable[Card], reviews: Iterable[Review]) -> datetime | None:
    """When the next of these cards is due; None where none was ever answered."""
    keys = {card.key for card in cards}
    return next((review.due for review in reviews if review.name in keys), None)


def to_practise(commands: Mapping[str, str], folders: Sequence[Path]) -> tuple[Practise, ...]:
    """The questions of the checklist that have a command, each with that and those of its katas.

    Where that is empty, it is a topic, a kata or any cards. Raises ProblemError where the checklist fails.
    """
    here = {folder.name for folder in problem_folders(folders)}
    checklist = read_checklist(folders)
    found = []
    for row in checklist.rows:
        if row.id in commands:
            starts = [f"judge start {kata}" for kata in row.katas if kata in here]
            quizzes = [f"judge quiz {topic}" for topic in checklist.topics(row.skills)]
            first = commands[row.id] or [*quizzes, *starts, "judge quiz"][0]
            found.append(Practise(row.id, row.ask, tuple(dict.fromkeys([first, *starts]))))
    return tuple(found)


# -- the interview -----------------------------------------------------------------------------------------


def interview_cards(minutes: int) -> tuple[int, int]:
    """How many cards come before the kata, at least two, and after it, at least one."""
    return max(2, minutes // _BEFORE), max(1, minutes // _AFTER)


def plan(cards: Sequence[Card], count: int, found: Sequence[Topic]) -> list[Card]:
    """So many cards, from easy to hard and then those of no set; at least one of each topic that is open."""
    firsts = [next((card for card in cards if card.key in each.weak), None) for each in found]
    chosen = {card.key: card for card in (*firsts, *cards) if card}
    ranks = {name: at for at, name in enumerate(SETS)}
    return sorted(
        [*chosen.values()][:count],
        key=lambda card: min([ranks[each] for each in card.sets if each in ranks], default=len(SETS)),
    )


def usual_kata(name: str, mine: Learner) -> Problem:
    """The first unsolved kata of that set, or of the person's own; else of the next one; or any."""
    katas = [kata for part in mine.from_own(name) for kata in mine.counted(part)] or [*mine.problems]
    return next((each for each in katas if each.id not in mine.solved), katas[0])


def lacking(problem: Problem, last: Result) -> tuple[str, ...]:
    """The skills of the problem that a run did not show."""
    passed = {group.name for group in last.groups if group.verdict is Verdict.AC}
    return tuple(skill.name for skill in problem.skills if not passed.issuperset(skill.groups))


def left_open(problem: Problem, skills: Sequence[str], folders: Sequence[Path]) -> dict[str, str]:
    """The questions of the checklist that need those skills, or else the kata, each with a command."""
    command = f"judge {'hint' if problem.has_hints else 'show'} {problem.id}"
    return {
        row.id: command
        for row in read_checklist(folders).rows
        if not {*skills}.isdisjoint(row.skills) or (not skills and problem.id in row.katas)
    }
