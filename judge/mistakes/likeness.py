"""How alike a submission's wrong answers are to those of programs that make a known mistake: one formula.

Of the failures, how many the known program has too, half of it where it gives another answer; out of these
failures and those that it alone has. Compared are the first cases of each group.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence, Set
from typing import NamedTuple

from judge.mistakes.computed import CASES
from judge.mistakes.family import Maker
from judge.run.result import Behaviour
from judge.values.outline import Outline, only_digits

_FEW = 5  # failures, below which nothing is like anything
_ENOUGH = 0.6  # of likeness, for a name
_AHEAD = 0.15  # of the next name

Place = tuple[str, int]  # a group, and a case of it
Wrong = Mapping[Place, Outline]


class Known(NamedTuple):
    """A program that makes a mistake, and what it answers."""

    maker: Maker
    behaviour: Behaviour


class Likeness:
    """A submission, by what it `does`, beside known programs."""

    def __init__(self, known: Sequence[Known], does: Behaviour) -> None:
        self._given = wrong_of(does)
        self._reached = {group: min(CASES, answers.reached) for group, answers in does.items()}
        self._known: dict[str, list[tuple[Known, Wrong]]] = {}
        for each in known:
            self._known.setdefault(each.maker.name, []).append((each, wrong_of(each.behaviour)))
        self._own = {each.maker.name for each in known if not each.maker.general}

    @property
    def names(self) -> Collection[str]:
        """All that are known."""
        return self._known.keys()

    @property
    def state(self) -> Collection[str]:
        """Those that are made only where something is kept between calls."""
        return {name for name, (first, *_) in self._known.items() if first[0].maker.words.state}

    def share(
        self, name: str, some: Collection[Place] | None = None, right: Set[Place] = frozenset()
    ) -> float:
        """How alike it is to the nearest program with that mistake, in `some` of the failures, or in all.

        What is `right` is no failure any more.
        """
        return max(self._shares(name, some, right), default=0.0)

    def nearest(self, name: str, some: Collection[Place] | None = None) -> Known:
        """The program with that mistake that it is most like."""
        shares = self._shares(name, some, frozenset())
        return self._known[name][shares.index(max(shares))][0]

    def _shares(self, name: str, some: Collection[Place] | None, right: Set[Place]) -> list[float]:
        given = self._given.keys() if some is None else self._given.keys() & set(some)
        return [self._share(given, wrong, self._given.keys() - right) for _, wrong in self._known[name]]

    def _share(self, places: Collection[Place], wrong: Wrong, failing: Set[Place]) -> float:
        both = [each for each in places if each in wrong]
        same = sum(_same(self._given[each], wrong[each]) for each in both)
        others = sum(
            case < self._reached.get(group, 0) and (group, case) not in failing for group, case in wrong
        )
        return (same + 0.5 * (len(both) - same)) / max(1, len(places) + others)

    def best(self) -> tuple[str, float] | None:
        """The name that it is most like, and how much, where that is sure.

        One of the kata's own goes before a twin of all katas.
        """
        if len(self._given) < _FEW:
            return None
        shares = {name: self.share(name) for name in self._known}
        ordered = sorted(shares, key=lambda name: (-round(shares[name], 9), name not in self._own, name))
        if not ordered or shares[ordered[0]] < _ENOUGH:
            return None
        first, *rest = ordered
        if first in self._own:
            rest = [name for name in rest if name in self._own or shares[name] < shares[first]]
        ahead = shares[first] - max((shares[name] for name in rest), default=0.0)
        return (first, shares[first]) if ahead >= _AHEAD else None


def wrong_of(does: Behaviour) -> Wrong:
    """The wrong answers to the cases that are compared."""
    return {
        (group, case): outline
        for group, answers in does.items()
        for case, outline in answers.wrong.items()
        if case < CASES
    }


def _same(given: Outline, other: Outline) -> bool:
    return given == other or (given[0] == other[0] and only_digits(given[1], other[1]))
