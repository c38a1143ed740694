"""What is told of a problem's mistakes by name, without running anything of the pack."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from judge.errors import ProblemError
from judge.mistakes.catalogue import read_catalogue
from judge.problem import Problem
from judge.problem.solutions import SolutionKind, read_solutions, usual_first


class Told(Struct, frozen=True):
    """One mistake: its first sentence, and the whole advice."""

    sentence: str
    advice: str


def told_mistakes(problem: Problem) -> Mapping[str, Told]:
    """Every mistake by its name: what mistakes.toml says, or the usual program of wrong/.

    A file that cannot be read is passed over: `judge verify` tells of it.
    """
    found: dict[str, Told] = {}
    for each in usual_first(read_solutions(problem, SolutionKind.WRONG).programs):
        found.setdefault(each.name, Told(each.sentence, each.advice))
    try:
        catalogue = read_catalogue(problem)
        aimed = {name for group in problem.groups for name in group.kills}
    except ProblemError:
        return found
    for name, words in catalogue.items():
        if name in aimed and words.told:
            found[name] = Told(words.seen, words.told)
    return found
