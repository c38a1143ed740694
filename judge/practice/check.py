"""What a kata needs beyond being judged: hints, a stub, cards, sets and skills. For `judge verify`."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from contextlib import nullcontext
from pathlib import Path

from judge.errors import JudgeError, ProblemError
from judge.practice.checklist import unknown_skills
from judge.practice.quiz.cards import read_decks
from judge.practice.quiz.questions import Sources, ask
from judge.practice.sets import set_names, unknown_sets
from judge.practice.stub import make_stub
from judge.problem import Problem
from judge.problem.find import problem_roots
from judge.problem.texts import read_hints
from judge.run.verify import Fault


def kata_faults(problem: Problem, extra: Sequence[Path] = ()) -> Iterator[Fault]:
    """The setter's faults; `extra` are folders of problems to look in first for the sets and skills."""
    for fault in _faults(problem, extra):
        yield _told(fault, problem.id)


def deck_faults(folders: Sequence[Path], katas: Collection[str]) -> tuple[int, tuple[Fault, ...]]:
    """How many cards are there, and a fault for each that cannot be asked.

    They are the cards of the `katas`; without any, those of all decks in the `folders`, or of all there are.
    """
    decks, broken = read_decks(folders)
    roots = problem_roots(folders)[: len(folders) or None]
    cards = [card for deck in decks if deck.path.parents[1] in roots for card in deck.cards]
    if katas:
        cards, broken = [card for deck in decks for card in deck.cards if card.problem in katas], []
    faults = [_told(fault, "quiz") for fault in broken]
    sources = Sources(folders, 0, lambda _label: nullcontext())
    for card in cards:
        try:
            ask(card, sources, "check")
        except JudgeError as fault:
            faults.append(_told(fault, card.key))
    return len(cards), tuple(faults)


def _told(fault: JudgeError, where: str) -> Fault:
    return Fault(fault.what, fault.where or where, fault.remedy or "")


def _faults(problem: Problem, extra: Sequence[Path]) -> Iterator[ProblemError]:
    for check in (read_hints, make_stub):
        try:
            check(problem)
        except ProblemError as fault:
            yield fault
    yield from unknown_sets(problem, set_names(extra))
    try:
        yield from unknown_skills([problem], extra)
    except ProblemError as fault:  # of a file of skills
        yield fault
