"""From a repair to what is said: a name for each step where that is sure, else the line and the kind's words.

The kind of a step proposes names, those that the kata has; among them decides how alike the failures that go
with the step are to those of the known program: one formula.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pkgutil import get_data
from typing import NamedTuple

from msgspec.structs import replace

from judge.mistakes.catalogue import EXAMPLE, Kinds
from judge.mistakes.likeness import Known, Likeness, Place
from judge.problem.toml import parse_toml
from judge.repair.changed import WAYS
from judge.repair.search import Repair, Step, Steps
from judge.run.result import MistakeStep, Pitfall, Result

_TOLD = 0.55  # share of the failures that a name of the kind must have
_ANY = 0.75  # … and one that the kind does not propose: half of the answers are the same,
_AHEAD = 0.15  # by so much more than the next one
_BEHIND = 0.05  # … and no more than so much less than one that the kind does not propose
_SAME = 0.9  # … and one of what is proved without a name
_ALL = 0.98  # from here on all answers are those of the known program
LIKELY = 0.9  # the score of a name that is very likely
_LAST = "rounding"  # what is left after all other steps
_STRONG = 0.87  # a kind that says what it is even where it explains a part
_MANY = 3  # steps, of which each may only fit what is left
_FEW = 5  # failures: fewer are like too much
_WORTH = 0.5  # of the failures that steps must take away where they do not take all
_SURE = ("fresh",)  # the kind proves the name
_STRENGTH = {  # how likely a repair of that kind is the mistake itself; 0.6 where it is not listed
    **dict.fromkeys(("fresh", "parameter-order"), 1.0),
    **dict.fromkeys(("clamp", "guard-left-out", "whole-division"), 0.95),
    **dict.fromkeys(("near", "copied", "guard-same", "guard-zero", "once", "order"), 0.9),
    **dict.fromkeys(("tolerance-scaled", "tolerance-smaller", "tolerance-none", "guard-exact", "size"), 0.87),
    **dict.fromkeys(("filter", "root", "square", "abs", "room", "doubles", "moved", "scaled"), 0.8),
    **dict.fromkeys(("compare-equal", "compare-turned", "form", "without-round", "without-int"), 0.75),
    **dict.fromkeys(("sign", "coordinates", "without-float", "without-sorted"), 0.7),
    **dict.fromkeys(("condition", "measure", "constant", "operator", "dropped", "missing"), 0.45),
}
_WIDTHS = ("tolerance", "size", "room")  # a known program has another width, and may pass any case
_ROOM = (*_WIDTHS, "near")
SEEN = parse_toml((get_data(__package__, "seen.toml") or b"").decode(), "seen.toml")  # by kind
_LINE = "line"  # … and where it is not proved which kind it is
_PROVED = ("rounding", "fresh", "parameter-order")  # what a name must not contradict


class _Named(NamedTuple):
    step: Step
    name: str
    share: float


class Repaired:
    """What a repair says of a program, beside what known programs answer."""

    def __init__(self, repair: Repair, likeness: Likeness, kinds: Kinds, *, few: bool) -> None:
        """`few` says that a kata has so few different answers that many mistakes have the same."""
        self._repair, self._kinds, self.failing = repair, kinds, repair.failing
        self._places: list[Place] = [(each.group.group.name, each.place) for each in repair.cases.all]
        self._likeness, self._few = likeness, few
        kept = {*self.names("fresh"), *likeness.state}
        state = () if "fresh" in repair.ways else kept  # it keeps nothing between its calls
        self._known = [name for name in likeness.names if name not in state]
        others = {name for kind in kinds if kind not in (_LAST, *WAYS) for name in self.names(kind)}
        self._rounds = {*self.names(_LAST)} - others if repair.wrong_on_paper else set()

    def chosen(self) -> list[_Named]:
        """The chain of steps that explains best, each with its name where that is sure."""
        repair = self._repair
        everything = frozenset(repair.cases.wrong)
        chains = [*repair.whole, *((Step(way, 0, everything),) for way in repair.ways)]
        if chains:
            often = Counter(step.line for chain in chains for step in chain)
            best = max((self._steps(chain) for chain in chains), key=lambda one: self._rank(one, often))
            return _at_one_place(best)
        gone = frozenset[int]().union(*(step.gone for step in repair.part))
        lines = [step.line for step in repair.part]
        if repair.broken or len(gone) < _WORTH * len(everything) or len({*lines}) < len(lines):
            return []  # or one line was made to fit some cases, and then others
        return [_Named(step, "", 0.0) for step in repair.part]

    def _rank(self, steps: Sequence[_Named], often: Mapping[int, int]) -> tuple[float, int, int]:
        """Of chains that are worth the same the one of the fewest lines, and then of those that most have."""
        lines = sum(one.step.lines for one in steps)
        return self._worth(steps), -lines, sum(often[one.step.line] for one in steps)

    def _worth(self, steps: Sequence[_Named]) -> float:
        each = [self._strength(one) + 0.8 * one.share - _untold(one) for one in steps]
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
        """Each with its name: that of a step before it, where what goes is as alike to that mistake."""
        found, before = list[_Named](), frozenset[int]()
        for step in chain:
            one = self._named(step, before)
            same = (
                each.name for each in found if each.name and self.share(each.name, step.gone) >= one.share
            )
            found.append(one._replace(name=next(same, one.name)) if one.name else one)
            before |= step.gone
        return found

    def _named(self, step: Step, before: frozenset[int]) -> _Named:
        """The step with its name; the steps `before` it have made these failures right."""
        kind = _plain(step.kind)
        names = [name for name in self.names(kind) if name in self._known]
        if "scaled" in self._repair.ways and kind.startswith(("tolerance", "size", "room")):
            names = [name for name in ("absolute-epsilon", *names) if name in self._known]
        if kind in _SURE and names:
            return _Named(step, names[0], 1.0)
        shares = {name: self.share(name, step.gone, before) for name in self._known}
        first = min(shares, key=lambda name: (-shares[name], name), default="")
        best = max(names, key=lambda name: shares[name] - 0.02 * names.index(name), default="")
        proved, most = kind in _PROVED or self._few, shares.get(first, 0.0)
        ahead = most - max((share for name, share in shares.items() if name != first), default=0.0)
        if len(step.gone) < _FEW:
            return _Named(step, "", shares.get(best, 0.0))
        if not proved and most >= _ALL and ahead > 0:
            return _Named(step, first, most)
        twin = most >= _ALL and ahead == 0  # another mistake has all of these answers, too
        if best and not twin and shares[best] >= max(most - _BEHIND, _SAME if proved else _TOLD):
            return _Named(step, best, shares[best])
        if not proved and most >= _ANY and ahead >= _AHEAD and first not in self._rounds:
            return _Named(step, first, most)
        return _Named(step, "", shares.get(best, 0.0))

    def names(self, kind: str) -> Sequence[str]:
        """Those that a repair of that kind may have."""
        words = self._kinds.get(kind)
        return words.names if words else ()

    def share(self, name: str, gone: frozenset[int], before: frozenset[int] = frozenset()) -> float:
        """How alike the failures that go are to those of the known programs of that name."""
        if name not in self._known:
            return 0.0
        some, right = ({self._places[at] for at in each} for each in (gone, before))
        return self._likeness.share(name, some, right)

    def text(self, one: _Named) -> str:
        """What is said of the program of that name that is most alike; where it is not, what is proved."""
        if not one.step.line and self.share(one.name, one.step.gone) < _SAME:
            return self.why(one.step)
        text = self.nearest(one).maker.wrong
        proved = one.name in self.names(_plain(one.step.kind)) or self.share(one.name, one.step.gone) >= _SAME
        return text if proved else seen_in(text)

    def nearest(self, one: _Named) -> Known:
        """The program of that name that is most alike."""
        return self._likeness.nearest(one.name, [self._places[at] for at in one.step.gone])

    @property
    def tells(self) -> bool:
        """Whether the pack says anything of repairs."""
        return bool(self._kinds)

    def why(self, step: Step) -> str:
        """What is said of a repair of that kind; only that the line is wrong where the kind is not proved."""
        kind, _, which = step.kind.partition(":")
        words = self._kinds.get(kind)
        seen = (words.seen if words else "") or SEEN.get(f"{kind}-{which}") or SEEN[kind]
        if step.lines > 1 and kind.startswith(_WIDTHS[0]):
            seen = SEEN["tolerances"]
        return seen.replace("{which}", which.replace("=", " = ")) if self._proves(step) else SEEN[_LINE]

    def _proves(self, step: Step) -> bool:
        """Whether it is the kind that is wrong: not where other kinds at this line are enough as well.

        Nor where it gives room for rounding, and the program is wrong without rounding, nor where a weak kind
        makes few cases right.
        """
        repair, kind = self._repair, _plain(step.kind)
        if (step,) not in repair.whole:
            return True
        if kind.startswith(_ROOM):
            return repair.rounding or repair.tolerance
        here = {_plain(each.kind) for each, *more in repair.whole if not more and each.line == step.line}
        strength, many = _STRENGTH.get(kind, 0.6), len(step.gone) >= _FEW
        return (len(here - {_LAST}) <= 1 and (many or strength > 0.5)) or strength >= _STRONG


def _at_one_place(steps: Sequence[_Named]) -> list[_Named]:
    """The steps, those of one name or one kind in one line as one: both ends of a comparison, say."""
    found: dict[tuple[str, int], _Named] = {}
    for one in steps:
        key = one.name or one.step.kind, one.step.line
        first = found.get(key, one)
        gone, lines = first.step.gone | one.step.gone, max(first.step.lines, one.step.lines)
        found[key] = first._replace(step=replace(first.step, gone=gone, lines=lines))
    return [*found.values()]


def seen_in(text: str) -> str:
    """What is said of answers, without the example of code, which may be otherwise in a program."""
    return text.partition(f" {EXAMPLE}")[0]


def _untold(one: _Named) -> float:
    """What a step is worth less that has no name, or not even a line."""
    return 0.0 if one.name else 0.15 if one.step.line else 0.45


def _plain(kind: str) -> str:
    return kind.partition(":")[0]


def with_steps(result: Result, repaired: Repaired, fails: Callable[[Known], bool] = lambda _: True) -> Result:
    """The result with what the repair says, beside the name that it may have already.

    Where the two tell of different things, and neither is proved, the name is all that is said. No name is,
    where none of the programs of these names `fails` the case that is shown.
    """
    found = repaired.chosen()
    if not found:
        return result
    today = result.pitfall
    if today is not None and _contradicts(repaired, today, found):
        today = None
    if today is not None and len(found) == 1 == len(today.names):
        found = [found[0]._replace(name=today.names[0])]
    elif today is not None:
        bearing = [one for one in found if one.name in today.names]
        if not bearing:
            return result
        if today.score >= LIKELY:  # the other steps would say less
            found = bearing
    sure = {*(today.names if today else ())}  # looked at already
    sure |= {one.name for one in found if one.step.kind in _SURE or one.step.kind.startswith(_WIDTHS)}
    if not any(one.name in sure or fails(repaired.nearest(one)) for one in found if one.name):
        found = [one._replace(name="", share=0.0) for one in found]
    found = [one for one in found if one.name or one.step.gone]
    if not found:
        return result
    steps = _told(found, repaired)
    named = {one.name: one.share for one in found if one.name}
    texts = {one.name: repaired.text(one) for one in reversed(found) if one.name}
    advice = tuple(texts[name] for name in named)
    score = round(min(named.values(), default=0.0), 3)
    return replace(result, pitfall=Pitfall(tuple(named), score, advice, steps=steps))


def _told(found: Sequence[_Named], repaired: Repaired) -> tuple[MistakeStep, ...]:
    """The steps in words, the largest first.

    Only the line is told where something stays wrong or there are many, and none is strong.
    """
    gone = frozenset[int]().union(*(one.step.gone for one in found))
    steps = []
    for step, name, _ in sorted(found, key=lambda one: (_plain(one.step.kind) == _LAST, -len(one.step.gone))):
        kind = _plain(step.kind)
        whole = len(gone) == repaired.failing and (len(found) < _MANY or kind in _PROVED)
        sure = whole or _STRENGTH.get(kind, 0.0) >= _STRONG
        why = repaired.why(step) if sure else ""
        steps.append(MistakeStep(name or None, kind, step.line, step.count, repaired.failing, why))
    return tuple(steps)


def _contradicts(repaired: Repaired, today: Pitfall, found: Sequence[_Named]) -> bool:
    """Whether the repair is a whole proof of something else than the name says."""
    kinds = [_plain(one.step.kind) for one in found]
    if not repaired.tells:  # a pack that says nothing of repairs
        return False
    if len(found) == 1 and kinds[0] in _PROVED:
        return not set(today.names) <= set(repaired.names(kinds[0]))
    gone = frozenset[int]().union(*(one.step.gone for one in found))
    may = {one.name for one in found}.union(*map(repaired.names, kinds))
    return len(gone) == repaired.failing and today.score < _ALL and not may.intersection(today.names)
