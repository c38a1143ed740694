"""Where a person stands: the current kata, what is due again, which kata comes next. Nothing is written."""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.resolve import current, history_at, this_folder
from judge.practice import events
from judge.practice.events import Answer, Help
from judge.practice.progress import levels, solved, stars, tried
from judge.practice.syllabus import next_kata, sound_sets
from judge.problem import Problem
from judge.problem.find import sound_problems
from judge.report.published_look import Again, Home, Next, Now, Standing

if TYPE_CHECKING:
    from judge.cli.options import Common


def home(common: Common) -> Home:
    """Where a person stands, and what to do now. Raises StoreError."""
    problems, _ = sound_problems(common.problems)
    with history_at(common.db, reading=True) as history:
        runs, answers, helps = history.runs(), history.events(Answer), history.events(Help)
        here, places = current(this_folder(), history), history.places()
    own, done, today = tried(runs), solved(runs), events.now().astimezone()
    won = list(stars(levels(problems, own)).values())
    at = here or next((each for each in places if os.path.isfile(each.path)), None)  # noqa: PTH113
    now = again = None
    if at and at.problem not in done:
        path, last = Path(at.path), own[at.problem][-1] if at.problem in own else None
        points, mistake = (last.score, last.mistake or "") if last else (None, "")
        now = Now(at.problem, path.name, "" if here else str(path.parent), points, mistake)
    if runs:
        from judge.practice.review import reviews

        names = {each.id for each in problems} - {now.problem if now else ""}
        for each in reviews(runs, helps):
            if each.solved and each.is_due(today) and each.name in names:
                again = Again(each.name, (today.date() - each.last.astimezone().date()).days)
                break
    cards = []
    if answers:
        from judge.practice.cards import known_cards

        cards = known_cards(answers, common.problems)
    return Home(
        katas=len(problems),
        begun=bool(own or places or answers),
        solved=_counted(done, problems),
        stars=(won.count(1), won.count(2)),
        now=now,
        again=again,
        next=_next(at.problem if at else "", problems, common, done),
        cards_due=sum(each.is_due(today) for each in cards),
    )


def standing(problem: str, common: Common) -> Standing:
    """What a kata took the person, and what comes after it. Raises JudgeError."""
    with history_at(common.db, reading=True) as history:
        runs = history.runs()
        hints = max((each.hints for each in history.events(Help, problem)), default=0)
    problems, _ = sound_problems(common.problems)
    return Standing(
        runs=len(tried(runs).get(problem, ())),
        hints=hints,
        next=_next(problem, problems, common, solved(runs)),
        solved=_counted(solved(runs), problems),
        katas=len(problems),
    )


def _next(after: str, problems: Sequence[Problem], common: Common, done: Collection[str]) -> Next | None:
    found = next_kata(after, problems, sound_sets(problems, common.problems)[0], done)
    return Next(found.id, found.title, found.summary) if found else None


def _counted(done: Collection[str], problems: Sequence[Problem]) -> int:
    return sum(each.id in done for each in problems)
