"""What `judge` and `judge start` say: where a person stands, and the file that a kata begins with."""

from __future__ import annotations

from msgspec import Struct

from judge.report.published import Published


class Next(Struct, frozen=True):
    """A kata to take up: its id, its title and a sentence about it."""

    problem: str
    title: str
    summary: str


class Now(Struct, frozen=True):
    """The kata a person is at, which is not solved: its file, and the folder where that is not this one.

    `points` and `mistake` are those of the last run; None and "" where there was none.
    """

    problem: str
    file: str
    folder: str
    points: int | None
    mistake: str


class Again(Struct, frozen=True):
    """A kata to solve again today, and how many days ago it was solved."""

    problem: str
    days: int


class Standing(Struct, frozen=True):
    """What a kata took a person, the kata that comes next, and how many of all are solved."""

    runs: int
    hints: int
    next: Next | None
    solved: int
    katas: int


class Home(Published, frozen=True):
    """Where a person stands: katas solved, those with one star and with two, and what to do now.

    Of a person who has not begun, `begun` is false, and `next` is the kata to begin with. `next` is None
    where all are solved.
    """

    katas: int
    begun: bool
    solved: int
    stars: tuple[int, int]
    now: Now | None
    again: Again | None
    next: Next | None
    cards_due: int


class Begun(Published, frozen=True):
    """A kata that was started: its file, and whether that was created now, or started over.

    `entry` is the function to write. `kept` is the file that keeps the text of before, or "".
    """

    problem: str
    title: str
    entry: str
    file: str
    created: bool
    kept: str
