"""Which cards are asked next, what to practise afterwards, and the mock interview: cards, a kata, cards."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from datetime import datetime
from itertools import zip_longest
from pathlib import Path

from msgspec import Struct

from judge.practice.cards import Card, read_decks
from judge.practice.progress import State, skills
from judge.practice.review import Learner, Review, card_reviews
from judge.practice.syllabus import SETS, Checklist, Syllabus, read_checklist
from judge.problem import Problem, Verdict
from judge.problem.find import problem_folders
from judge.run.result import Result

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


def next_cards(
    cards: Sequence[Card],
    reviews: Sequence[Review],
    now: datetime,
    count: int,
    *,
    near: Sequence[str] = (),
    weak: Sequence[Collection[str]] = (),
    ahead: bool = False,
) -> list[Card]:
    """The cards in their turn: due ones, the longest overdue first, then new ones.

    If `count` are asked, half of their new ones are `weak`, which are the keys of cards by topic, one topic
    after the other; half are of the first of the sets `near`. Both are of these sets while there are any.
    With `ahead` those follow that are due later.
    """
    by_key = {card.key: card for card in cards}
    known = [(by_key[review.name], review.is_due(now)) for review in reviews if review.name in by_key]
    answered = {card.key for card, _ in known}
    new = [card for card in cards if card.key not in answered]
    due = [card for card, is_due in known if is_due]
    close = [card for card in new if not {*near}.isdisjoint(card.sets)]
    turns = zip_longest(*([card for card in close if card.key in keys] for keys in weak))
    topical = list({card.key: card for turn in turns for card in turn if card}.values())
    own = sorted(close, key=lambda card: near[0] not in card.sets)
    later = [card for card, is_due in known if not is_due] if ahead else []
    half = max(count - len(due) + 1, 0) // 2
    return list({card.key: card for card in (*due, *topical[:half], *own, *new, *later)}.values())


def near_sets(own: str) -> tuple[str, ...]:
    """That set, the one below and the one above."""
    if own not in SETS:
        return (own,)
    at = SETS.index(own)
    return (own, *SETS[max(at - 1, 0) : at], *SETS[at + 1 : at + 2])


class Wanted:
    """Which cards a person is asked next; `name` is the set that was named."""

    def __init__(self, name: str, mine: Learner) -> None:
        self.mine, self.answered = mine, card_reviews(mine.answers)
        self._near = near_sets(next((each.name for each in mine.from_own(name)), ""))
        checklist = read_checklist(mine.extra)
        self.weak = [each.weak for each in topics(mine, read_decks(mine.extra)[0], checklist)]

    def of(self, cards: Sequence[Card], now: datetime, count: int, *, ahead: bool = False) -> list[Card]:
        """These cards in their turn, of which so many are asked."""
        return next_cards(cards, self.answered, now, count, near=self._near, weak=self.weak, ahead=ahead)


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


def plan(wanted: Sequence[Card], count: int, weak: Sequence[Collection[str]]) -> list[Card]:
    """So many cards, from easy to hard and then those of no set; at least one of each topic that is open."""
    firsts = [next((card for card in wanted if card.key in keys), None) for keys in weak]
    chosen = {card.key: card for card in (*firsts, *wanted) if card}
    kept = [*chosen.values()][:count]
    return sorted(
        kept, key=lambda card: next((at for at, each in enumerate(SETS) if each in card.sets), len(SETS))
    )


def usual_kata(name: str, course: Syllabus) -> Problem:
    """The first unsolved kata of that set, or of the person's own; else of the next one; or any."""
    katas = [kata for part in course.from_own(name) for kata in course.counted(part)] or [*course.problems]
    return next((each for each in katas if each.id not in course.solved), katas[0])


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
