"""The bench that mutants are judged on: which of them the data accept, and which are wrong on a case."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, pairwise
from math import inf
from random import Random
from time import monotonic
from typing import NamedTuple

from judge.cache import digest
from judge.data import ProblemData
from judge.data.build import target_of, validate
from judge.data.pins import hash_of
from judge.diagnose.candidates import items_of
from judge.holes.cases import Solved
from judge.holes.model import KnownMutants
from judge.holes.programs import GIVEN_UP, Base, Candidate, Candidates, original
from judge.holes.rows import suppressed_after
from judge.problem import Case, Group, Problem, Tolerance
from judge.problem.declare import decisions
from judge.sandbox.boundary import Reply, Stop
from judge.values.answers import Exact, Target, within
from judge.values.check import is_right
from judge.verify.model import Progress

_WAVES = (0, 8, 32, 128, 512, None)  # cases that are asked before the rest: most mutants die there
_AT_ONCE = 512  # mutants that are judged to their end, before the next ones are begun, at most
_LEAST = 16  # … and at least; of slow programs, one for so many calls in a second of CPU:
_CALLS = 50
_KEPT = 4  # groups that are remembered to reject a mutant
_FEW = 4  # answers of a mutant that are looked at first: most are wrong at once
_RUNGS = 8  # of a ladder that are judged at once; of other numbers, which are slow, two
_ENOUGH = 3  # accepted rungs, below which all others are taken for accepted; of other numbers one
_NEARLY = 1e-5  # a gap below it may be the promise's own
_EDGE = 1.1  # times the least gap, below which a rounding decides
_LONG = 1000  # items of a case, above which it takes a program too much time to be asked of every mutant
_MOST_KNOWN = 50_000  # cases whose answers are remembered


class Aimed(NamedTuple):
    """A case of the data, or one that was found, and what an answer to it is held against."""

    case: Case
    target: Target
    group: Group
    place: str = ""  # hash of its group
    exact: Exact = None  # the answer, where it is known


class Bench:
    """The data of a kata, a crowd to ask, and what is known of its mutants from earlier runs.

    Of the data it asks the small groups whose cases are not long, and of few mutants every small group.
    """

    def __init__(
        self,
        problem: Problem,
        sets: Sequence[ProblemData],
        crowd: Candidates,
        kept: KnownMutants,
        progress: Progress,
    ) -> None:
        self.problem, self.crowd = problem, crowd
        self.module = sets[0].module
        self.until = inf  # when the time is up
        self._kept, self._progress = kept, progress
        self._sets, self._every = ([_mixed(data, most) for data in sets] for most in (_LONG, inf))
        self._usual = _usual(sets[0])
        left_out = len(self._sets[0]) < sum(len(each.cases) for each in sets[0].groups)
        self._largest = max(items_of(each.case) for each in self._sets[0]) if left_out else inf
        self._memo: dict[str, Solved | None] = {}
        self._least: dict[str, float] = {}

    @property
    def late(self) -> bool:
        """Whether the time is up."""
        return monotonic() >= self.until

    def is_right(self, base: Base) -> bool:
        """Whether all sets of data accept it."""
        for aimed in self._sets:
            known = original(base).key + _whole(aimed)
            if known not in self._kept.passed and self.failing(base, aimed):
                return False
            self._kept.passed[known] = ""
        return True

    def judged(self, made: Sequence[Candidate]) -> tuple[list[Candidate], int, bool]:
        """Those that are accepted, how many were judged, and whether that was before the time was up.

        Of a ladder none is judged below a few accepted rungs.
        """
        ladders: dict[str, list[Candidate]] = {}
        for each in made:
            ladders.setdefault(each.ladder, []).append(each)
        batch = ladders.pop("", [])
        accepted, judged, high = list[Candidate](), 0, Counter[str]()
        while True:
            for ladder, rungs in ladders.items():
                enough, few = (1, 2) if rungs and rungs[0].mutant.numbers[0] else (_ENOUGH, _RUNGS)
                if high[ladder] < enough:
                    batch += rungs[:few]
                    del rungs[:few]
            if not batch:
                return accepted, judged, True
            Random(0).shuffle(batch)  # some of every kind, should the time be up before the end
            while batch:
                size = max(_LEAST, min(_AT_ONCE, self.crowd.most // _CALLS))
                part, batch = batch[:size], batch[size:]
                self._progress("judging mutants", judged, len(made))
                passed, left = self._judged(part, self._sets)
                judged += len(part) - left
                accepted += passed
                if left:
                    return accepted, judged, False
                high.update(each.ladder for each in passed)

    def accepted(self, some: Sequence[Candidate]) -> list[Candidate]:
        """Those of them that every small group of one of the sets accepts."""
        return self._judged(some, self._every)[0]

    def _judged(
        self, some: Sequence[Candidate], sets: Sequence[Sequence[Aimed]]
    ) -> tuple[list[Candidate], int]:
        """Those of them that one of the sets accepts, and for how many the time was up before."""
        kept, left, accepted = self._kept, list(some), list[Candidate]()
        for aimed in sets:
            places, whole = {each.place for each in aimed}, _whole(aimed)
            dead = [each for each in left if places.intersection(kept.killed.get(each.key, ()))]
            accepted += [each for each in left if kept.passed.get(each.key) == whole]
            known = {each.key for each in (*dead, *accepted)}
            alive = [each for each in left if each.key not in known]
            for first, last in pairwise(_WAVES):
                waiting, alive, cases = alive, [], aimed[first:last]
                while waiting:
                    if self.late:
                        again = [] if aimed is sets[-1] else dead  # the next set may accept them
                        return accepted, len(alive) + len(waiting) + len(again)
                    size = self.crowd.most // (len(cases) or 1) + 1
                    passed, more = self._survivors(waiting[:size], cases)
                    waiting = waiting[size:]
                    alive += passed
                    dead += more
            kept.passed |= dict.fromkeys([each.key for each in alive], whole)
            accepted += alive
            left = dead
        return accepted, 0

    def _survivors(
        self, some: Sequence[Candidate], aimed: Sequence[Aimed]
    ) -> tuple[list[Candidate], list[Candidate]]:
        """Those that answer all of the cases rightly, and the others."""
        alive, dead = list[Candidate](), list[Candidate]()
        for candidate, wrong in zip(some, self.wrong(some, aimed, 1), strict=True):
            if not wrong:
                alive.append(candidate)
                continue
            dead.append(candidate)
            kept = self._kept.killed.setdefault(candidate.key, [])
            kept.append(aimed[wrong[0]].place)
            del kept[:-_KEPT]
        return alive, dead

    def wrong(self, some: Sequence[Candidate], aimed: Sequence[Aimed], most: int = 0) -> Iterator[list[int]]:
        """The places of the cases that each answers wrongly, and not as its base; `most` of them, or all."""
        cases = [each.case for each in aimed]
        others = [*self.crowd.differing(some, cases)]
        found: list[list[int]] = [[] for _ in some]
        asked = [0] * len(some)
        size = _FEW if most else len(cases)
        while True:
            work = [
                (at, others[at][asked[at] : asked[at] + size])
                for at in range(len(some))
                if asked[at] < len(others[at]) and not (most and len(found[at]) >= most)
            ]
            if not work:
                return iter(found)
            replies = self.crowd.answers([(some[at], [cases[i] for i in places]) for at, places in work])
            for (at, places), own in zip(work, replies, strict=True):
                found[at] += [
                    i for i, reply in zip(places, own, strict=False) if not self._right(reply, aimed[i])
                ]
                asked[at] += size
                if len(own) < len(places) or own[-1:] == [GIVEN_UP]:  # its process ended
                    asked[at] = len(cases)
            size *= 4

    def _right(self, reply: Reply, aimed: Aimed) -> bool:
        """Whether it is the right answer; an exception is none, nor a call that was stopped."""

        def truth() -> tuple[Exact, Tolerance]:
            exact = aimed.exact if aimed.place == "" else self.module.solve(*aimed.case)
            return within(exact, aimed.group.name), aimed.group.tolerance

        answered = reply.stop is Stop.ANSWERED
        return answered and is_right(self.problem.answer, reply.answer, aimed.target, truth)

    def failing(self, base: Base, aimed: Sequence[Aimed]) -> set[int]:
        """The places of the cases on which a right program is wrong."""
        parts = [aimed[at : at + self.crowd.most] for at in range(0, len(aimed), self.crowd.most)]
        work = [(original(base), [each.case for each in part]) for part in parts]
        replies = chain.from_iterable(self.crowd.answers(work))
        pairs = zip(replies, aimed, strict=False)
        return {at for at, (reply, each) in enumerate(pairs) if not self._right(reply, each)}

    def solved(self, case: Case) -> Solved | None:
        """What a valid case comes to; None for any other, and for one that takes too long.

        None, too, for one that is larger than all that are asked, where groups of larger ones are not:
        those may reject who is slow there, or wrong.
        """
        if items_of(case) > self._largest:
            return None
        key = repr(case)
        if key in self._memo:
            return self._memo[key]
        if len(self._memo) > _MOST_KNOWN:
            self._memo.clear()
        found = None
        with suppressed_after(0.3), decisions() as told:
            exact = validate(self.problem, self.module, case)
            gaps: dict[str, float] = {}
            for each in told:
                if each.gap:
                    gaps[each.what] = min(gaps.get(each.what, 1.0), abs(each.gap))
            found = Solved(exact, gaps)
        for what, gap in found.gaps.items() if found else ():
            self._least[what] = min(self._least.get(what, _NEARLY), gap)
        self._memo[key] = found
        return found

    def clear(self, solved: Solved) -> bool:
        """Whether no decision is at the very edge of what is promised."""
        return all(gap >= min(_EDGE * self._least[what], _NEARLY) for what, gap in solved.gaps.items())

    def aimed(self, case: Case, solved: Solved) -> Aimed:
        """A case that was found, under the tolerance that most groups have."""
        group = self._usual
        target = target_of(self.problem, within(solved.exact, group.name), group.tolerance)
        return Aimed(case, target, group, exact=solved.exact)

    def shows(self, some: Mapping[str, Candidate], cases: Sequence[Case]) -> list[set[str]]:
        """For each case the mutants that are wrong on it, and their base is right."""
        aimed = [self.aimed(case, solved) for case in cases if (solved := self.solved(case))]
        if not aimed:
            return []
        failing = {base: self.failing(base, aimed) for base in {each.base for each in some.values()}}
        found: list[set[str]] = [set() for _ in cases]
        for (key, each), places in zip(some.items(), self.wrong([*some.values()], aimed), strict=True):
            for at in set(places) - failing[each.base]:
                found[at].add(key)
        return found


def _mixed(data: ProblemData, most: float) -> list[Aimed]:
    """The cases of its small groups that have no longer ones, of each group in turn; or of all small ones."""
    small = [each for each in data.groups if each.group.size is None]
    rows = []
    for each in [each for each in small if max(map(items_of, each.cases)) <= most] or small:
        place = hash_of(each)
        pairs = zip(each.cases, each.targets, strict=True)
        rows.append([Aimed(case, target, each.group, place) for case, target in pairs])
    longest = max(map(len, rows), default=0)
    return [row[at] for at in range(longest) for row in rows if at < len(row)]


def _whole(aimed: Sequence[Aimed]) -> str:
    """What a set of data is known by."""
    return digest("".join(sorted({each.place for each in aimed})).encode())[:24]


def _usual(data: ProblemData) -> Group:
    """A small group with the tolerance that most of them have."""
    groups = [each.group for each in data.groups if each.group.size is None]
    kinds = [repr(each.tolerance) for each in groups]
    return groups[kinds.index(max(kinds, key=kinds.count))]
