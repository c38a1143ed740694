"""Where a person stands: the current kata, what is due again, which kata comes next. Nothing is written."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from judge.cli.resolve import current, history_at, this_folder
from judge.practice import events
from judge.practice.events import Answer, Help
from judge.practice.progress import levels_passed, skills, solved, tried
from judge.practice.syllabus import Course, Skill, read_course
from judge.report.published_look import Again, Home, Next, Now, Standing

if TYPE_CHECKING:
    from judge.cli.options import Common


def home(common: Common) -> Home:
    """Where a person stands, and what to do now. Raises StoreError."""
    with history_at(common.db, reading=True) as history:
        runs, answers, helps = history.runs(), history.events(Answer), history.events(Help)
        here, places = current(this_folder(), history), history.places()
    course, own = read_course(solved(runs), common.problems), tried(runs)
    today = events.now().astimezone()
    won = [len(levels_passed(each, own.get(each.id, ()))) for each in course.problems]
    at = here or next((each for each in places if os.path.isfile(each.path)), None)  # noqa: PTH113
    now = again = None
    if at and at.problem not in solved(runs):
        path, last = Path(at.path), own[at.problem][-1] if at.problem in own else None
        points, mistake = (last.score, last.mistake or "") if last else (None, "")
        now = Now(at.problem, path.name, "" if here else str(path.parent), points, mistake)
    if runs:
        from judge.practice.review import reviews

        names = {each.id for each in course.problems} - {now.problem if now else ""}
        due = (each for each in reviews(runs, helps) if each.solved and each.is_due(today))
        if found := next((each for each in due if each.name in names), None):
            again = Again(found.name, (today.date() - found.last.astimezone().date()).days)
    cards = []
    if answers:
        from judge.practice.cards import known_cards

        cards = known_cards(answers, common.problems)
    return Home(
        katas=len(course.problems),
        begun=bool(own or places or answers),
        solved=len(course.solved),
        stars=(won.count(1), won.count(2)),
        now=now,
        again=again,
        next=_next(course, at.problem if at else ""),
        cards_due=sum(each.is_due(today) for each in cards),
    )


def standing(problem: str, common: Common) -> Standing:
    """What a kata took the person, and what comes after it. Raises JudgeError."""
    with history_at(common.db, reading=True) as history:
        runs, hints = history.runs(), history.hints_seen(problem)
    course, own = read_course(solved(runs), common.problems), tried(runs)
    mine = own.get(problem, [])
    shows = [Skill(each.name, "") for kata in course.problems if kata.id == problem for each in kata.skills]
    found = skills(course.problems, own, shows) if mine else []
    return Standing(
        runs=len(mine),
        new=tuple(each.name for each in found if each.since == mine[-1].when),
        hints=hints,
        next=_next(course, problem),
        solved=len(course.solved),
        katas=len(course.problems),
    )


def _next(course: Course, after: str) -> Next | None:
    found = course.next(after)
    return Next(found.id, found.title, found.summary) if found else None
