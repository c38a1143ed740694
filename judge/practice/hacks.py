"""The wrong programs that a person broke with a case of their own (`judge hack`), as evidence.

    with History.open(reading=True) as history:
        shares = hack_shares(problems, history.events(Hack))     # one for each problem that was tried
        broken(history.events(Hack, "count"))                      # mistake -> when it was first broken

A program is broken by a case that keeps the promise and that it answers wrongly; by the case that was shown
to whoever gave it up, it is not.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from enum import Enum

from msgspec import Struct

from judge.practice.events import Hack, Outcome
from judge.problem import Problem


class HackState(Enum):
    """How a wrong program stands; the value is its name in JSON."""

    OPEN = "open"
    BROKEN = "broken"
    GIVEN_UP = "given-up"


class HackShare(Struct, frozen=True):
    """Of a problem's `programs` wrong ones, those that were broken: by mistake, when it was done first."""

    problem: str
    programs: int
    broken: Mapping[str, datetime]


def broken(hacks: Iterable[Hack]) -> dict[str, datetime]:
    """The mistakes of one problem whose program was broken, and when first; the attempts are in order."""
    found: dict[str, datetime] = {}
    shown: set[tuple[str, str]] = set()
    for hack in hacks:
        if hack.outcome is Outcome.GIVEN_UP:
            shown.add((hack.mistake, hack.case))
        elif hack.outcome is Outcome.WON and (hack.mistake, hack.case) not in shown:
            found.setdefault(hack.mistake, hack.when)
    return found


def was_shown(mistake: str, case: str, hacks: Iterable[Hack]) -> bool:
    """Whether the case was shown to whoever gave up that mistake of one problem."""
    return any(
        hack.outcome is Outcome.GIVEN_UP and (hack.mistake, hack.case) == (mistake, case) for hack in hacks
    )


def hack_states(mistakes: Iterable[str], hacks: Sequence[Hack]) -> dict[str, HackState]:
    """How the program of each of one problem's mistakes stands."""
    done = broken(hacks)
    shown = {hack.mistake for hack in hacks if hack.outcome is Outcome.GIVEN_UP}
    return {
        name: HackState.BROKEN if name in done else HackState.GIVEN_UP if name in shown else HackState.OPEN
        for name in mistakes
    }


def hack_shares(problems: Iterable[Problem], hacks: Sequence[Hack]) -> list[HackShare]:
    """The share of each of these problems that was tried; the mistakes of no other are read.

    Raises ProblemError where the files that tell of a problem's mistakes are broken.
    """
    from judge.mistakes.puzzles import read_puzzles  # most people's history has no attempt

    tried: dict[str, list[Hack]] = {}
    for hack in hacks:
        tried.setdefault(hack.problem, []).append(hack)
    found = []
    for problem in problems:
        if problem.id in tried:
            known = {puzzle.mistake for puzzle in read_puzzles(problem)}
            done = {name: when for name, when in broken(tried[problem.id]).items() if name in known}
            found.append(HackShare(problem.id, len(known), done))
    return found
