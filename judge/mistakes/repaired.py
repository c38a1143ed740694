"""From a repair to what is said: a name for each step where that is sure, else the line and the kind's words.

The kind of a step proposes names, those that the kata has; among them decides how alike the failures that go
with the step are to those of the known program: one formula.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from msgspec.structs import replace

from judge.mistakes.catalogue import Catalogue, Kinds
from judge.mistakes.naming import Known
from judge.repair.search import Repair, Step, Steps
from judge.run.result import Behaviour, MistakeStep, Pitfall, Result
from judge.values.outline import Outline

_TOLD = 0.55  # share of the failures that a name of the kind must have
_FITS = 0.3  # … and one that is today's already
_ANY = 0.6  # … and one that the kind does not propose,
_AHEAD = 0.15  # by so much more than the next one
_SAME = 0.9  # … and one of what is proved without a name
_ALL = 0.95  # from here on all answers are those of the known program
_FEW = 5  # failures, below which nothing is like anything
_WORTH = 0.5  # of the failures that steps must take away where they do not take all
_SURE = ("fresh", "doubles")  # the kind proves the name
_STRENGTH = {  # how likely a repair of that kind is the mistake itself; 0.6 where it is not listed
    **dict.fromkeys(("fresh", "parameter-order"), 1.0),
    **dict.fromkeys(("clamp", "guard-left-out", "whole-division"), 0.95),
    **dict.fromkeys(("near", "guard-same", "guard-zero", "once", "order"), 0.9),
    **dict.fromkeys(("tolerance-scaled", "tolerance-smaller", "tolerance-none", "guard-exact", "size"), 0.87),
    **dict.fromkeys(("filter", "root", "square", "abs", "room", "doubles", "moved", "scaled"), 0.8),
    **dict.fromkeys(("compare-equal", "compare-turned", "form", "without-round", "without-int"), 0.75),
    **dict.fromkeys(("sign", "coordinates", "without-float", "without-sorted", "single"), 0.7),
    **dict.fromkeys(("condition", "measure", "constant", "operator", "dropped", "branch"), 0.45),
}
_PROVED = ("rounding", "fresh", "parameter-order")  # what a name must not contradict

Place = tuple[str, int]  # a group, and a case of it
Wrong = Mapping[Place, Outline]


class _Named(NamedTuple):
    step: Step
    name: str
    share: float


class Repaired:
    """What a repair says of a program, beside what known programs answer."""

    def __init__(self, repair: Repair, known: Sequence[Known], does: Behaviour, kinds: Kinds) -> None:
        self._repair, self._kinds, self.failing = repair, kinds, repair.failing
        self._places = [(each.group.group.name, each.place) for each in repair.cases.all]
        self._given = _wrong_of(does)
        self._known: dict[str, list[Wrong]] = {}
        for each in known:
            self._known.setdefault(each.name, []).append(_wrong_of(each.behaviour))

    def chosen(self) -> list[_Named]:
        """The chain of steps that explains best, each with its name where that is sure."""
        repair = self._repair
        everything = frozenset(repair.cases.wrong)
        chains = [*repair.whole, *((Step(way, 0, everything),) for way in repair.ways)]
        if chains:
            return max((self._steps(chain) for chain in chains), key=self._worth)
        gone = frozenset[int]().union(*(step.gone for step in repair.part))
        if len(gone) < _WORTH * len(everything):
            return []
        return [_Named(step, "", 0.0) for step in repair.part]

    def _worth(self, steps: Sequence[_Named]) -> float:
        each = [self._strength(one) + 0.8 * one.share - (0 if one.name else 0.15) for one in steps]
        return round(sum(each) / len(each) - 0.25 * (len(each) - 1), 6)

    def _strength(self, one: _Named) -> float:
        kind = _plain(one.step.kind)
        worth = _STRENGTH.get(kind, 0.6)
        if self._repair.rounding and kind in ("tolerance-smaller", "tolerance-none"):
            worth -= 0.4  # without rounding its tolerances do no harm
        if self._repair.tolerance and kind in ("room", "near"):
            worth -= 0.3  # without them it is right
        return worth

    def _steps(self, chain: Steps) -> list[_Named]:
        return [self._named(step) for step in chain]

    def _named(self, step: Step) -> _Named:
        kind = _plain(step.kind)
        names = [name for name in self.names(kind) if name in self._known]
        if "scaled" in self._repair.ways and kind.startswith(("tolerance", "size", "room")):
            names = [name for name in ("absolute-epsilon", *names) if name in self._known]
        if kind in _SURE and names:
            return _Named(step, names[0], 1.0)
        shares = {name: self.share(name, step.gone) for name in self._known}
        ordered = sorted(shares, key=lambda name: (-shares[name], name))
        if ordered and len(step.gone) >= _FEW and shares[ordered[0]] >= _ALL:
            next_one = shares[ordered[1]] if len(ordered) > 1 else 0.0
            if next_one < shares[ordered[0]] and kind not in _PROVED:
                return _Named(step, ordered[0], shares[ordered[0]])
        best = max(names, key=lambda name: shares[name] - 0.02 * names.index(name), default=None)
        if best is not None and shares[best] >= (_SAME if kind in _PROVED else _TOLD):
            return _Named(step, best, shares[best])
        if len(ordered) > 1 and kind not in _PROVED and len(step.gone) >= _FEW:
            first, second = shares[ordered[0]], shares[ordered[1]]
            if first >= _ANY and first - second >= _AHEAD:
                return _Named(step, ordered[0], first)
        return _Named(step, "", shares[best] if best else 0.0)

    def joined(self, found: Sequence[_Named], names: Sequence[str]) -> list[_Named]:
        """The steps, one without a name with that of today's which its kind may have and its failures fit."""
        made = [*found]
        for name in names:
            if any(one.name == name for one in made):
                continue
            for at, one in enumerate(made):
                kind = _plain(one.step.kind)
                least = _TOLD if kind in _PROVED else _FITS
                if not one.name and name in self.names(kind) and self.share(name, one.step.gone) >= least:
                    made[at] = one._replace(name=name)
                    break
        return made

    def names(self, kind: str) -> Sequence[str]:
        """Those that a repair of that kind may have."""
        words = self._kinds.get(kind)
        return words.names if words else ()

    def share(self, name: str, gone: frozenset[int]) -> float:
        """Of the failures that go, how many the known program has too, half of it for another answer."""
        places = [self._places[at] for at in gone]
        return max((self._share(places, wrong) for wrong in self._known[name]), default=0.0)

    def _share(self, places: Sequence[Place], wrong: Wrong) -> float:
        both = [each for each in places if each in wrong]
        same = sum(self._given.get(each) == wrong[each] for each in both)
        asked = set(self._places)
        others = sum(each in asked and each not in self._given for each in wrong)
        return (same + 0.5 * (len(both) - same)) / max(1, len(places) + others)


def _plain(kind: str) -> str:
    return kind.partition(":")[0]


def _wrong_of(does: Behaviour) -> Wrong:
    return {(group, case): outline for group, a in does.items() for case, outline in a.wrong.items()}


def with_steps(result: Result, repaired: Repaired, kinds: Kinds, words: Catalogue) -> Result:
    """The result with what the repair says, beside the name that it may have already."""
    found = repaired.chosen()
    if not found:
        return result
    today = result.pitfall
    if today is not None and _contradicts(repaired, today, found):
        today = None
    if today is not None and len(found) == 1 == len(today.names):
        found = [found[0]._replace(name=today.names[0])]
    elif today is not None:
        found = repaired.joined(found, today.names)
        if not any(one.name in today.names for one in found):
            return replace(result, pitfall=replace(today, steps=_told(found, repaired.failing, kinds)))
    steps = _told(found, repaired.failing, kinds)
    if today is not None and {one.name for one in found} >= {*today.names}:
        return replace(result, pitfall=replace(today, steps=steps))
    named = {one.name: one.share for one in found if one.name}
    advice = tuple(words[name].why if name in words else "" for name in named)
    score = round(min(named.values(), default=0.0), 3)
    return replace(result, pitfall=Pitfall(tuple(named), score, advice, steps=steps))


def _told(found: Sequence[_Named], failing: int, kinds: Kinds) -> tuple[MistakeStep, ...]:
    steps = []
    for one in found:
        kind, _, which = one.step.kind.partition(":")
        why = kinds[kind].why.replace("{which}", which.replace("=", " = ")) if kind in kinds else ""
        steps.append(MistakeStep(one.name or None, kind, one.step.line, len(one.step.gone), failing, why))
    return tuple(steps)


def _contradicts(repaired: Repaired, today: Pitfall, found: Sequence[_Named]) -> bool:
    """Whether the repair is a whole proof of something else than the name says."""
    kind = _plain(found[0].step.kind)
    return len(found) == 1 and kind in _PROVED and not set(today.names) <= set(repaired.names(kind))
