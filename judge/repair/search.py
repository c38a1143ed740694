"""Questions 2 to 4: is it rounding alone, which one change makes the program right, and which several.

All that is asked of the contained process are answers; whether they are right is decided here. What is tried
is bounded by counts, so that the same program gets the same name on every machine, and ties are decided by
kind, line and text of an edit, not by where it stands among the others.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import cached_property
from typing import NamedTuple

from msgspec import Struct

from judge.data import ProblemData
from judge.repair.cases import Cases
from judge.repair.changed import Changed
from judge.repair.child import Beside, Child, LostError, Table
from judge.repair.edits import KINDS
from judge.run.execute import Judgement
from judge.run.result import Behaviour
from judge.run.runner import Runner
from judge.sandbox.boundary import Box
from judge.values.wire import Raw

_SAMPLE = 150  # cases of each kind that are run without rounding
_LEFT = 60  # of those that remain after a step
_TURNS = 12  # cases whose comparisons are looked at
_LINES = 3  # of comparisons that may be what turns, and the share of the failures that one has to explain
_PART = 0.2
_MOST_CALLS = 170_000
_BEAM = 2
_WORTH = 0.1  # of the failures that a step must take away
_SHRUNK = ("1e-30", "1e-900")  # a tolerance that is next to nothing, and one that is nothing at all
_ROUNDING = (  # the edits that can matter where no formula is wrong
    *("room", "near", "tolerance-none", "tolerance-smaller", "tolerance-scaled", "size", "guard-exact"),
    *("compare-equal", "without-round", "without-int", "without-float", "without", "whole-division", "root"),
    *("without-set", "order"),
)
_COMPARED = ("room", "near", "compare-equal")  # … only where a comparison comes out otherwise by rounding
_FEW = 4  # statements of which each alone may be what rounds
_MANY = ("missing",)  # edits that are so many that only quick programs, and no second steps, have them
_AFTER = ("once", "filter", "order")  # what is asked of the answers themselves
SURE = ("fresh", "parameter-order", "near", "once", "clamp", "without-round", "whole-division")


class _Counts(NamedTuple):
    wrong: int  # cases on which every candidate is tried first
    right: int  # … and every good one
    good: int  # candidates that are tried on these
    full: int  # candidates of a level that are run on all cases
    of_a_place: int  # of these with one kind at one line
    depth: int  # steps of a chain


_USUAL = _Counts(14, 26, 2_000, 16, 4, 3)
_FEWER = _Counts(8, 16, 40, 5, 1, 1)  # of a program that works on arrays


class Step(Struct, frozen=True):
    """One change: its kind, its line (0 where it has none), and the failures that go with it, by place."""

    kind: str
    line: int
    gone: frozenset[int] = frozenset()
    lines: int = 1  # that it changes, of which the first is told
    own: int | None = None  # of those gone that the line alone decides, where it is not all

    @property
    def count(self) -> int:
        """How many failures are gone by what is done at its line."""
        return len(self.gone) if self.own is None else self.own


Steps = tuple[Step, ...]


class Repair(Struct, frozen=True, kw_only=True):
    """What was found out of a wrong program.

    `whole` are chains of steps after which nothing fails; `part` is the best one after which less does,
    though `broken` cases do that did not. `ways` are those of question 1 in which it is right. Without
    rounding it is right as it is (`rounding`), or once no tolerance is wider than nothing (`tolerance`); what
    is `wrong_on_paper` could be run so, and is not right as it is.
    """

    cases: Cases
    whole: tuple[Steps, ...] = ()
    part: Steps = ()
    broken: int = 0
    ways: tuple[str, ...] = ()
    rounding: bool = False
    tolerance: bool = False
    wrong_on_paper: bool = False

    @property
    def failing(self) -> int:
        """How many of the cases that it was asked fail."""
        return len(self.cases.wrong)


class _State(NamedTuple):
    chain: tuple[int, ...]  # edits inside the box
    after: tuple[str, ...]  # what is made of the answers
    guarded: frozenset[int]  # cases whose answer is taken to be right
    steps: Steps
    wrong: frozenset[int]


class _Candidate(NamedTuple):
    gain: float
    rank: tuple[int, int, int, int]
    number: int
    after: tuple[str, ...]


class RepairSearch:
    """One program; `share` of the usual budget is spent."""

    def __init__(self, cases: Cases, child: Child, share: float = 1.0) -> None:
        self._cases, self._child = cases, child
        self._most = int(_MOST_CALLS * share)
        self._everything = [*range(len(cases.all))]
        self._start = frozenset(cases.wrong)
        self._counts = _FEWER if child.arrays else _USUAL
        self._exact = True  # whether it can be run without rounding
        self._deadly: set[tuple[str, int, int, int]] = set()  # edits that end the process

    def repair(self, ways: tuple[str, ...]) -> Repair:
        """What is found, in the order of the questions. Raises LostError."""
        start = self._start
        found = Repair(cases=self._cases, ways=ways)
        if not start or "fresh" in ways:
            return found
        self._most //= self._child.try_out(self._everything[: self._counts.wrong])
        factor = self._without_rounding(None, start, _SAMPLE)
        whole, part = self._chains(_State((), (), frozenset(), (), start), bool(factor))
        if factor:
            turned = self._child.turning(None, self._cases.spread(start, _LEFT), ("", factor)).lines
            whole = [steps for steps in whole if steps[0].kind not in _COMPARED or steps[0].line in turned]
        if factor == "1" and not any(steps[-1].kind in SURE for steps in whole):
            whole.append((self._rounding(None, start),))
        elif factor in _SHRUNK and not whole:
            step = self._turning("tolerance-smaller", ("1", factor), None, start)
            whole += [(step,)] if step.line else []
        return Repair(
            cases=self._cases,
            whole=tuple(whole),
            part=part.steps,
            broken=len(part.wrong - start),
            ways=ways,
            rounding=factor == "1",
            tolerance=factor in _SHRUNK,
            wrong_on_paper=factor not in ("1", None),
        )

    def _chains(self, state: _State, rounding: bool) -> tuple[list[Steps], _State]:
        """Chains that make it right, and the best one that does not."""
        states, part = [state], state
        for _ in range(1 if rounding else self._counts.depth):
            full = self._counts.full // len(states)
            made = [each for one in states for each in self._next(one, rounding, full)]
            made.sort(key=_order)
            whole = [each.steps for each in made if not each.wrong]
            if whole:  # whatever else makes a new object there is right for the same reason
                return [steps for steps in whole if steps[-1].kind == "copied"] or whole, part
            states = _apart(made)[:_BEAM]
            if not states:
                break
            part = states[0]
            whole = [] if rounding else [steps for each in states for steps in self._rounded(each)]
            if whole:
                return whole, part
        return [], part

    @cached_property
    def _rounds(self) -> bool:
        """Whether it rounds as it is: what an edit alone brings in is no mistake of its own."""
        few = sorted({*self._cases.spread(self._start, _LEFT), *self._cases.spread(self._everything, _LEFT)})
        (plain,), (exact,) = self._child.answers((), few), self._child.exactly(None, ("1",), few)
        return plain != exact or bool(self._child.turning(None, few).lines)

    def _rounded(self, state: _State) -> Iterator[Steps]:
        """The steps, and that what is left is rounding, if it is."""
        if self._rounds and self._without_rounding(state.chain, state.wrong, _LEFT, state):
            yield (*state.steps, self._rounding(state.chain, state.wrong, state))

    # -- question 2 ------------------------------------------------------------------------------------

    def _without_rounding(
        self, chain: Sequence[int] | None, wrong: frozenset[int], most: int, state: _State | None = None
    ) -> str | None:
        """The factor of its tolerances with which it is right without rounding, "" for none.

        None where it cannot be run so.
        """
        if not self._exact:
            return None
        sample = sorted({*self._cases.spread(wrong, most), *self._cases.spread(self._everything, most)})
        factors = ("1",) if state else ("1", *_SHRUNK)
        found = self._child.exactly(chain, factors, sample)
        right = [not self._wrong(pairs, sample, state) for pairs in found]
        self._exact = found[0] is not None or chain is not None
        none = "" if found[0] is not None else None
        return next((factor for factor, one in zip(factors, right, strict=True) if one), none)

    def _rounding(
        self, chain: Sequence[int] | None, wrong: frozenset[int], state: _State | None = None
    ) -> Step:
        """Where rounding does the harm: at a statement that is enough, else at a comparison that turns."""
        few = self._cases.spread(wrong, self._counts.wrong)
        rows = self._child.unrounded(chain, (), few)
        some = [at for at, (_, pairs) in enumerate(rows) if not self._wrong(pairs, few, state)][-_FEW:]
        for line, pairs in reversed(self._child.unrounded(chain, some, self._everything) if some else []):
            if not self._wrong(pairs, self._everything, state):
                return Step("rounding:loses", line, wrong & self._start)
        return self._turning("rounding", ("", "1"), chain, wrong, state)

    def _turning(
        self,
        kind: str,
        factors: tuple[str, str],
        chain: Sequence[int] | None,
        wrong: frozenset[int],
        state: _State | None = None,
    ) -> Step:
        """The line whose comparisons make most of these right once they come out as in the second run."""
        places, gone = sorted(wrong), dict[int, frozenset[int]]()
        for line in self._child.turning(chain, self._cases.spread(wrong, _TURNS), factors).first[:_LINES]:
            pairs = self._child.decided(chain, factors[1], line, places)
            gone[line] = wrong - self._wrong(pairs, places, state)
        line = max(gone, key=lambda line: len(gone[line]), default=0)
        if not line or len(gone[line]) < _PART * len(wrong):
            return Step(kind, 0, wrong & self._start)
        return Step(f"{kind}:turns", line, wrong & self._start, own=len(gone[line] & self._start))

    def _wrong(
        self, pairs: Sequence[tuple[int, Raw]] | None, places: Sequence[int], state: _State | None
    ) -> frozenset[int]:
        """Those of the places whose answers are wrong."""
        after, guarded = (state.after, state.guarded) if state else ((), frozenset[int]())
        right = {at for at, raw in pairs or () if self._cases.right(at, raw, after)}
        return frozenset(places) - right - guarded

    # -- questions 3 and 4 -----------------------------------------------------------------------------

    def _next(self, state: _State, rounding: bool, full: int) -> Iterator[_State]:
        """The states that are one step further, with fewer wrong answers."""
        table = self._child.table(state.chain)
        yield from self._asides(state)
        few = self._cases.spread(state.wrong, self._counts.wrong)
        good = self._cases.spread(
            (at for at in self._everything if at not in state.wrong), self._counts.right
        )
        left_out = _MANY if self._counts is _FEWER else ()
        usable = [n for n, row in enumerate(table) if row not in self._deadly and row[0] not in left_out]
        numbers = [n for n in usable if not rounding or table[n][0] in _ROUNDING]
        numbers = numbers[: max(0, (self._most - self._child.calls) // max(1, len(few)))]
        first = self._tried(state, table, numbers, few)
        better = sorted((len(wrong), number) for number, _, wrong in first if len(wrong) < len(few))
        most = max(0, (self._most - self._child.calls) // max(1, len(good)))
        promising = sorted({number for _, number in better[: min(most, self._counts.good)]})
        second = {
            (number, after): len(wrong) for number, after, wrong in self._tried(state, table, promising, good)
        }
        right = len(self._everything) - len(state.wrong)
        worth = len(state.wrong) / max(1, len(few)), right / max(1, len(good))
        ranked = []
        for number, after, wrong in first:
            if number in promising:
                lost = second.get((number, after), 0)
                gain = (len(few) - len(wrong)) * worth[0] - lost * worth[1]
                kind, line, hash_, lines = table[number]
                ranked.append(_Candidate(gain, (KINDS.index(kind), lines, line, hash_), number, after))
        best = [*self._best(ranked, table, full)]
        runs = self._child.answers(state.chain, self._everything, [each.number for each in best])
        for each, pairs in zip(best, runs, strict=True):
            then = state._replace(after=each.after)
            left = self._wrong(pairs, self._everything, then)
            if len(state.wrong) - len(left) >= max(1, _WORTH * len(state.wrong)) or not left:
                kind, line, _, lines = table[each.number]
                step = Step(kind, line, (state.wrong - left) & self._start, lines)
                chain = (*state.chain, each.number)
                yield then._replace(chain=chain, steps=(*state.steps, step), wrong=left)

    def _best(self, ranked: list[_Candidate], table: Table, full: int) -> Iterator[_Candidate]:
        """Those that are worth all cases."""
        taken: dict[tuple[str, float], int] = {}
        left = min(full, (self._most - self._child.calls) // max(1, len(self._everything)))
        often = Counter((each.gain, *table[each.number][:2]) for each in ranked)

        def rank(each: _Candidate) -> tuple[float, ...]:
            """The best first; of as good ones of a kind those at a line that has most of them."""
            return -each.gain, *each.rank[:2], -often[each.gain, *table[each.number][:2]], *each.rank[2:]

        for each in sorted(ranked, key=rank):
            kind, line = table[each.number][:2]
            if each.gain <= 0 or left <= 0:
                return
            place = kind, each.gain if self._counts is _FEWER else line
            taken[place] = taken.get(place, 0) + 1
            if taken[place] <= self._counts.of_a_place:
                left -= 1
                yield each

    def _tried(
        self, state: _State, table: Table, numbers: Sequence[int], places: Sequence[int]
    ) -> list[tuple[int, tuple[str, ...], frozenset[int]]]:
        """Which of the cases are wrong with each edit; where a clamp goes, points beyond the ends go too."""
        if not numbers or not places:
            return [(number, state.after, frozenset()) for number in numbers]
        found = []
        for number, pairs in zip(numbers, self._child.answers(state.chain, places, numbers), strict=True):
            if pairs is None:
                self._deadly.add(table[number])
            found.append((number, state.after, self._wrong(pairs, places, state)))
            if table[number][0] == "clamp" and "filter" not in state.after:
                then = state._replace(after=(*state.after, "filter"))
                found.append((number, then.after, self._wrong(pairs, places, then)))
        return found

    def _leaving(self, state: _State, gone: frozenset[int]) -> int:
        return self._child.leaving(state.chain, self._cases.spread(gone, _TURNS))

    def _asides(self, state: _State) -> Iterator[_State]:
        """What is asked of the answers alone: cases that coincide, equal items, points beyond, the order."""
        for name, some in self._cases.guards(state.wrong):
            gone = state.wrong & some & self._start
            kind = f"guard-{'zero' if name.endswith('=0') else 'same'}"
            step = Step(f"{kind}:{name}", self._leaving(state, gone), gone)
            yield state._replace(
                guarded=state.guarded | some, steps=(*state.steps, step), wrong=state.wrong - some
            )
        (pairs,) = self._child.answers(state.chain, self._everything)
        for name in _AFTER if self._cases.several else ():
            if name in state.after:
                continue
            then = state._replace(after=(*state.after, name))
            left = self._wrong(pairs, self._everything, then)
            if len(left) < len(state.wrong):
                gone = (state.wrong - left) & self._start
                step = Step(name, self._leaving(state, gone), gone)
                yield then._replace(steps=(*state.steps, step), wrong=left)


def seek(
    data: ProblemData, judged: Judgement, box: Box, beside: Beside, *, share: float = 1.0
) -> Repair | None:
    """What makes the submission in `box` right; None where nothing is found, or it cannot be called.

    It is changed in the box beside; without a source in Python, or with a library in it, only question 1 is
    asked. Of the usual number of calls `share` are made. Raises JudgeError.
    """
    runner = judged.runner
    if runner is None:
        return None
    found = otherwise(data, judged.behaviour, runner, box)
    if runner.calls and beside.text is not None and found.cases.wrong:
        with suppress(LostError):
            found = RepairSearch(found.cases, Child(beside.box, beside.text, found.cases), share).repair(
                found.ways
            )
    return found if found.whole or found.part or found.ways else None


def otherwise(data: ProblemData, does: Behaviour, runner: Runner, box: Box) -> Repair:
    """What question 1 alone finds: for this no source is needed."""
    cases = Cases(data, does)
    return Repair(cases=cases, ways=Changed(cases, runner, box).ways())


def _order(state: _State) -> tuple[object, ...]:
    last = state.steps[-1]
    rank = KINDS.index(last.kind) if last.kind in KINDS else -1
    return len(state.wrong), rank, last.kind, last.lines, last.line, state.chain


def _apart(states: Sequence[_State]) -> list[_State]:
    """The first of those that say the same."""
    found: dict[tuple[tuple[str, int], ...], _State] = {}
    for each in states:
        found.setdefault(tuple((step.kind, step.line) for step in each.steps), each)
    return [*found.values()]
