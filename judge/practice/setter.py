"""For setters: what a kata needs beyond being judged (`judge verify`)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

from judge.errors import JudgeError, ProblemError
from judge.practice.cards import read_decks
from judge.practice.questions import ask
from judge.practice.stub import make_stub
from judge.practice.syllabus import unknown_names
from judge.problem import Problem
from judge.problem.find import problem_roots
from judge.problem.texts import read_hints
from judge.verify.model import Fault, Verified, fault_of


def kata_faults(problem: Problem, extra: Sequence[Path] = ()) -> list[Fault]:
    """The setter's faults; `extra` are folders of problems to look in first for the sets and skills."""
    found: list[ProblemError] = []
    for check in (read_hints, make_stub, lambda each: found.extend(unknown_names([each], extra))):
        try:
            check(problem)
        except ProblemError as fault:
            found.append(fault)
    return [fault_of(fault, problem.id) for fault in found]


def verify_decks(folders: Sequence[Path], katas: Collection[str]) -> Verified:
    """How many cards are there, and a fault for each that cannot be asked.

    They are the cards of the `katas`; without any, those of all decks in the `folders`, or of all there are.
    """
    cards, broken = read_decks(folders)
    faults = [] if katas else [fault_of(fault, "quiz") for fault in broken]
    roots = problem_roots(folders)[: len(folders) or None]
    own = {path.stem for root in roots for path in (root / "quiz").glob("*.toml")}
    cards = [card for card in cards if (card.problem in katas if katas else card.deck in own)]
    for card in cards:
        try:
            ask(card, folders, 0, "check")
        except JudgeError as fault:
            faults.append(fault_of(fault, card.key))
    return Verified("quiz", tuple(faults), cards=len(cards))
