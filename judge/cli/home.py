"""Where a person stands: the current kata, what is due again, which kata comes next. Nothing is written."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.kept import history_at
from judge.cli.resolve import current, this_folder
from judge.practice import events
from judge.practice.events import Answer, Help
from judge.practice.sets import USUAL, sound_sets
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.published_start import Again, Home, Next, Now, Standing

if TYPE_CHECKING:
    from judge.cli.options import Common
    from judge.practice.events import Run, Started
    from judge.practice.history import History
    from judge.practice.sets import PracticeSet


def home(common: Common) -> Home:
    """Where a person stands, and what to do now. Raises StoreError."""
    problems, _ = sound_problems(common.problems)
    with history_at(common.db, reading=True) as history:
        runs = [run for run in history.runs() if run.counts]
        here, places = current(this_folder(), history), history.places()
        at = here or next((each for each in places if os.path.isfile(each.path)), None)  # noqa: PTH113
        solved = {run.problem for run in runs if run.solved}
        open_at = at if at and at.problem not in solved else None
        following = next_kata(at.problem if at else "", problems, common.problems, solved)
        answers = history.events(Answer)
        begun = bool(runs or places or answers)
        return Home(
            katas=len(problems),
            begun=begun,
            solved=len(solved & {each.id for each in problems}),
            stars=_stars(problems, runs),
            now=_now(open_at, runs, elsewhere=here is None) if open_at else None,
            again=_again(history, open_at.problem if open_at else "", problems) if begun else None,
            next=Next(following.id, following.title, following.summary) if following else None,
            cards_due=_cards_due(answers, common.problems),
        )


def standing(problem: str, common: Common) -> Standing:
    """What a kata took the person, and what comes after it. Raises JudgeError."""
    with history_at(common.db, reading=True) as history:
        runs = [run for run in history.runs() if run.counts]
        hints = max((each.hints for each in history.events(Help, problem)), default=0)
    problems, _ = sound_problems(common.problems)
    solved = {run.problem for run in runs if run.solved}
    following = next_kata(problem, problems, common.problems, solved)
    return Standing(
        runs=sum(run.problem == problem for run in runs),
        hints=hints,
        next=Next(following.id, following.title, following.summary) if following else None,
        solved=len(solved & {each.id for each in problems}),
        katas=len(problems),
    )


def next_kata(
    after: str, problems: Sequence[Problem], folders: Sequence[Path], solved: Collection[str]
) -> Problem | None:
    """The kata that comes after that one and is not solved; None where all others are.

    First in its own set, from there on and then from the start, so that one that was left out comes back;
    then on the whole path.
    """
    own = set_of(after, problems, folders)
    path = next((each.problems for each in sound_sets(problems, folders)[0] if each.name == USUAL), problems)
    rows = chain(_from(after, own.problems if own else ()), _from(after, path))
    return next((each for each in rows if each.id not in solved and each.id != after), None)


def set_of(problem: str, problems: Sequence[Problem], folders: Sequence[Path]) -> PracticeSet[Problem] | None:
    """The set that a kata belongs to, the easiest one; None where it is in none but the whole path."""
    sets, _ = sound_sets(problems, folders)
    return next((each for each in sets if each.name != USUAL and problem in _names(each.problems)), None)


def solved_katas(history: History) -> set[str]:
    """The katas that the person has solved."""
    return {run.problem for run in history.runs() if run.solved}


def _names(problems: Iterable[Problem]) -> list[str]:
    return [each.id for each in problems]


def _from(after: str, problems: Sequence[Problem]) -> Sequence[Problem]:
    """The problems in their order, those behind `after` first."""
    names = _names(problems)
    at = names.index(after) + 1 if after in names else 0
    return [*problems[at:], *problems[:at]]


def _stars(problems: Iterable[Problem], runs: Sequence[Run]) -> tuple[int, int]:
    """How many katas have one star, the interview level, and how many two, production too."""
    if not runs:
        return 0, 0
    from judge.cli.commands.look import row_of

    tried = {run.problem for run in runs}
    rows = (
        row_of(each, [run for run in runs if run.problem == each.id]) for each in problems if each.id in tried
    )
    stars = [row.stars for row in rows]
    return stars.count(1), stars.count(2)


def _now(at: Started, runs: Sequence[Run], *, elsewhere: bool) -> Now:
    last = next((run for run in reversed(runs) if run.problem == at.problem), None)
    path = Path(at.path)
    points, mistake = (last.score, last.mistake or "") if last else (None, "")
    return Now(at.problem, path.name, str(path.parent) if elsewhere else "", points, mistake)


def _again(history: History, open_at: str, problems: Sequence[Problem]) -> Again | None:
    """The kata that is due the longest, of those that were solved."""
    from judge.practice.review import reviews

    today, names = events.now().astimezone(), _names(problems)
    for each in reviews(history.runs(), history.events(Help)):
        if each.solved and each.is_due(today) and each.name in names and each.name != open_at:
            return Again(each.name, (today.date() - each.last.astimezone().date()).days)
    return None


def _cards_due(answers: Sequence[Answer], folders: Sequence[Path]) -> int:
    """How many cards that were answered before are due today, of those that are still there."""
    if not answers:
        return 0
    from judge.practice.quiz.cards import read_decks
    from judge.practice.review import card_reviews

    found = card_reviews(answers)
    keys = {card.key for deck in read_decks(folders)[0] for card in deck.cards}
    return sum(each.name in keys and each.is_due(events.now().astimezone()) for each in found)
