"""The checklist as a history has it: rows, cards, skills and runs brought together."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Sequence
from datetime import datetime
from pathlib import Path

from judge.errors import ProblemError
from judge.kata.checklist import Checklist, Record, RowProgress, assess_rows, read_checklist
from judge.kata.events import Answer, Hack
from judge.kata.hacks import broken
from judge.kata.history import History
from judge.kata.quiz.cards import sound_decks
from judge.kata.skills import SkillProgress, assess, skills_of
from judge.kata.standing import standings
from judge.problem import Problem


def assessed_rows(
    history: History, problems: Sequence[Problem], extra: Sequence[Path], drills: Collection[str]
) -> tuple[Checklist, list[RowProgress], list[ProblemError]]:
    """The checklist, how each of its rows stands, and the faults of decks, which are left out.

    `problems` are all that can be found, `drills` the commands that there are. Raises ProblemError where the
    checklist itself is broken, HistoryError.
    """
    checklist = read_checklist(extra)
    decks, faults = sound_decks(extra)
    cards = [card for deck in decks for card in deck.cards]
    runs = history.runs()
    skills: list[SkillProgress] = assess(skills_of(problems, extra), runs, problems)
    record = Record(standings(runs), skills, history.events(Answer), _broken(history))
    here = [problem.id for problem in problems]
    rows = assess_rows(checklist.rows, record, cards, here, breaking="hack" in drills)
    return checklist, rows, faults


def _broken(history: History) -> dict[str, datetime]:
    """When each mistake was first broken with a case of the person's own, by "problem/mistake"."""
    of_problem: defaultdict[str, list[Hack]] = defaultdict(list)
    for hack in history.events(Hack):
        of_problem[hack.problem].append(hack)
    return {
        f"{problem}/{mistake}": when
        for problem, hacks in of_problem.items()
        for mistake, when in broken(hacks).items()
    }
