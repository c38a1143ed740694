"""What `judge quiz` and `judge interview` come to: frozen structs, whose field names are the JSON's keys."""

from __future__ import annotations

from datetime import datetime

from judge.practice.drill import DrillStep
from judge.practice.events import Answer
from judge.practice.quiz import Practise, Topic
from judge.problem import Verdict
from judge.published import Published


class Quizzed(Published, frozen=True):
    """How the cards went, and what to practise; `next_due` is told where none was asked."""

    asked: int
    known: int
    answers: tuple[Answer, ...]
    practise: tuple[Practise, ...]
    next_due: datetime | None = None


class Interviewed(Published, frozen=True):
    """How the interview went: the minutes it took, its cards, its kata, and what to practise.

    `verdict` and `score` are null where the file was not judged; `lacking` are skills that it did not show.
    """

    minutes: int
    out_of: int
    asked: int
    known: int
    problem: str
    file: str
    runs: int
    solved: bool
    verdict: Verdict | None
    score: int | None
    mistake: str | None
    lacking: tuple[str, ...]
    practise: tuple[Practise, ...]


class Drill(Published, frozen=True):
    """An evening of practice: how the topics stand, and the commands in their order."""

    time: datetime
    minutes: int
    topics: tuple[Topic, ...]
    steps: tuple[DrillStep, ...]
