"""Where a person stands: the current kata, what is due again, which kata comes next. Nothing is written."""

from __future__ import annotations

from judge.cli.options import Common
from judge.cli.resolve import current, history_at, is_there, seen_cards, this_folder
from judge.practice import events
from judge.practice.progress import skills
from judge.practice.review import read_learner
from judge.practice.syllabus import Skill, read_pack
from judge.problem.find import problem_roots
from judge.report.published_look import Home, Standing


def home(common: Common) -> Home:
    """Where a person stands, and what to do now. Raises StoreError."""
    with history_at(common.db, reading=True) as history:
        mine, places = read_learner(history, common.problems), history.places()
        here = current(this_folder(), history)
    at = here or next(filter(is_there, places), None)
    done = at is not None and any(run.solved for run in mine.own.get(at.problem, ()))
    return Home(
        learner=mine,
        due=mine.due(events.now().astimezone(), seen_cards(mine)),
        begun=bool(mine.own or places or mine.answers),
        now=None if done else at,
        here=here is not None,
        next=mine.next(at.problem if at else ""),
        topic=", ".join(read_pack(root).title for root in problem_roots(common.problems, installed=False)),
    )


def standing(problem: str, common: Common) -> Standing:
    """What a kata took the person, and what comes after it. Raises JudgeError."""
    with history_at(common.db, reading=True) as history:
        mine, hints = read_learner(history, common.problems), history.hints_seen(problem)
    runs = mine.own.get(problem, ())
    shows = [Skill(each.name, "") for kata in mine.problems if kata.id == problem for each in kata.skills]
    found = skills(mine.problems, mine.own, shows) if runs else []
    return Standing(
        runs=sum(run.path == runs[-1].path for run in runs),
        new=tuple(each.name for each in found if each.since == runs[-1].when),
        hints=hints,
        next=mine.next(problem),
        solved=len(mine.solved),
        katas=len(mine.problems),
        stars=mine.stars(mine.problems),
    )
