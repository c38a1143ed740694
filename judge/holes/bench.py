"""The bench that mutants are judged on: which of them the data accept, and which are wrong on a case."""

from __future__ import annotations

from array import array
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from math import inf
from pathlib import Path
from random import Random
from time import monotonic

from msgspec.structs import astuple, replace

from judge.cache import digest
from judge.data import ProblemData
from judge.data.build import target_of, validate
from judge.data.pins import hash_of
from judge.diagnose.candidates import items_of
from judge.holes import inside
from judge.holes.cases import Tried
from judge.holes.programs import Base, Candidate, original
from judge.holes.rows import suppressed_after
from judge.problem import Case, Tolerance
from judge.problem.declare import decisions
from judge.sandbox.boundary import Box, Limits, Reply, Stop
from judge.values.answers import Exact, within
from judge.values.check import is_right
from judge.values.wire import items
from judge.verify.model import Progress

SOURCE = Path(inside.__file__).read_bytes()
_FIRST = 64  # cases that all are asked before the rest, and how many of the rest at once
_PART = 512
_AT_ONCE = 256  # mutants that are judged to their end, before the next ones are begun
_FEW = 4  # answers of a mutant that are looked at first: most are wrong at once
_RUNGS = 8, 3  # of a ladder that are judged at once, and how many accepted ones end it
_NUMBERS = 2, 1  # … of other numbers, which are slow
_LIMITS = Limits(10.0, 300.0, 0, 64 << 20, 300.0)
_SECONDS = 0.5  # of CPU that mutants in one process should take
_SOLVING = 0.3  # … and that a case may
_NEARLY = 1e-5  # a gap below it may be the promise's own
_EDGE = Fraction(11, 10)  # times the least gap, or what an answer may be off, below which a rounding decides
_GIVEN_UP = Reply(Stop.EXITED)
_GOING_ON = Stop.ANSWERED, Stop.EXCEPTION

_Asked = tuple[Candidate, int, int, int]  # a mutant, the first case, that after the last, how many answers
Given = tuple[int, Reply]  # the place of a case that a mutant answers not as its base, and how
Enough = Callable[[Candidate, int], bool]


class Bench:
    """The small groups of a kata's data, a box on `SOURCE` to ask, and what is known from earlier runs.

    `known` says of a mutant and a set of data the hash of the group that rejects it, or that of the set.
    Raises TimeoutError when the time is up, JudgeError where nothing can be run.
    """

    def __init__(
        self, sets: Sequence[ProblemData], box: Box, known: dict[str, str], progress: Progress
    ) -> None:
        self.problem, self.module = sets[0].problem, sets[0].module
        self.until = inf  # when the time is up
        self._box, self._known, self._progress = box, known, progress
        self._sets = [_mixed(data) for data in sets]
        self._groups = [{each.place for each in aimed} for aimed in self._sets]
        self._wholes = [digest("".join(sorted(places)).encode())[:24] for places in self._groups]
        small = [each.group for each in sets[0].groups if each.group.size is None]
        kinds = [repr(each.tolerance) for each in small]
        usual = small[kinds.index(max(kinds, key=kinds.count))]  # with the tolerance that most have
        wider = Tolerance(*(_EDGE * each for each in astuple(usual.tolerance)))
        self._usual = replace(usual, tolerance=wider)
        sized = len(small) < len(sets[0].groups)
        self._largest = max(items_of(each.case) for each in self._sets[0]) if sized else inf
        self._least: dict[str, float] = {}
        self._size = 16  # mutants in one process, as fast as they turn out to be

    def _check_time(self) -> None:
        if monotonic() >= self.until:
            raise TimeoutError

    # -- asking ------------------------------------------------------------------------------------------

    def _called(self, work: Sequence[_Asked], cases: Sequence[Case]) -> list[list[Given]]:
        """What each one answers; after one that ends its process there are no more."""
        right = list(dict.fromkeys(original(each.base).made for each, *_ in work))
        given = [
            [(v.typecode, v) if isinstance(v, array) else v for v in case]
            for case in self.problem.calls(cases)
        ]
        calls: list[tuple[object, ...]] = [("begin", self.problem.called, right, given)]
        for each, first, last, most in work:
            base = right.index(original(each.base).made) if each.mutant.kind else -1
            calls.append(("differ", base, each.made, first, last, most))
            calls += [("answer", at) for at in range(most)]
        size = max(len(cases), self.problem.answer.items)
        limits = _LIMITS._replace(memory_bytes=self.problem.limits.memory_bytes, items=size)
        replies = self._box.call("ask", calls, limits).replies
        at, found = 1, list[list[Given]]()
        for _, first, _, most in work:
            own = replies[at : at + 1 + most]
            at += len(own)
            if len(own) <= most or own[-1].stop not in _GOING_ON:
                break
            places = items(own[0].answer) if own[0].stop is Stop.ANSWERED else None
            found.append([(first, own[0])] if places is None else [*zip(places, own[1:], strict=False)])
        return found

    def _asked(self, work: Sequence[_Asked], cases: Sequence[Case]) -> Iterator[list[Given]]:
        """What each one answers; of one that ends its process to one case after another."""
        while work:
            self._check_time()
            begun, part = monotonic(), work[: self._size]
            found = self._called(part, cases)
            if len(found) < len(part):
                each, first, last, _ = part[len(found)]
                single = self._called([(each, at, at + 1, 1) for at in range(first, last)], cases)
                ended = [(first + len(single), _GIVEN_UP)] if first + len(single) < last else []
                found.append([*chain.from_iterable(single), *ended])
            yield from found
            work, seconds = work[len(found) :], monotonic() - begun
            if seconds > 2 * _SECONDS:
                self._size = self._size // 2 or 1
            elif seconds < _SECONDS and len(part) == self._size:
                self._size *= 2

    def wrong(
        self, some: Sequence[Candidate], aimed: Sequence[Tried], enough: Enough | None = None
    ) -> Iterator[tuple[Candidate, list[int]]]:
        """Each one, and the places of the cases that it answers wrongly, and not as its base.

        All of them, or until one is `enough`.
        """
        cases = [each.case for each in aimed]
        most = _FEW if enough else len(cases)
        todo = [(each, 0, list[int]()) for each in some]
        while todo:
            work = [(each, first, len(cases), min(most, len(cases) - first)) for each, first, _ in todo]
            left = []
            for (each, _, bad), own in zip(todo, self._asked(work, cases), strict=True):
                bad += [at for at, reply in own if not self._right(reply, aimed[at])]
                last, reply = own[-1] if len(own) >= most > 0 else (len(cases), _GIVEN_UP)
                told = enough and any(enough(each, at) for at in bad)
                if told or reply is _GIVEN_UP or last + 1 == len(cases):
                    yield each, bad
                else:
                    left.append((each, last + 1, bad))
            todo, most = left, 4 * most

    def _right(self, reply: Reply, aimed: Tried) -> bool:
        """Whether it is the right answer; an exception is none, nor a call that was stopped."""

        def truth() -> tuple[Exact, Tolerance]:
            exact = self.module.solve(*aimed.case) if aimed.place else aimed.exact
            return within(exact, aimed.group.name), aimed.group.tolerance

        answered = reply.stop is Stop.ANSWERED
        return answered and is_right(self.problem.answer, reply.answer, aimed.target, truth)

    def reply(self, one: Candidate, case: Case) -> Reply:
        """What it answers to a case on which it is wrong."""
        (own,) = self._asked([(one, 0, 1, 1)], [case])
        return own[0][1] if own else _GIVEN_UP

    def failing(self, some: Iterable[Base], aimed: Sequence[Tried]) -> dict[Base, set[int]]:
        """For right programs the places of the cases on which they are wrong."""
        found: dict[Base, set[int]] = {base: set() for base in some}
        for first in range(0, len(aimed), _PART):
            for one, bad in self.wrong([*map(original, found)], aimed[first : first + _PART]):
                found[one.base] |= {first + at for at in bad}
        return found

    def shows(self, some: Sequence[Candidate], cases: Sequence[Tried]) -> list[set[str]]:
        """For each case the mutants that are wrong on it, and their base is right."""
        failing = self.failing((each.base for each in some), cases)
        wrong = {
            one.key: {*bad} - failing[one.base] for one, bad in self.wrong(some, cases, lambda *_: False)
        }
        return [{key for key, places in wrong.items() if at in places} for at in range(len(cases))]

    # -- judging -----------------------------------------------------------------------------------------

    def verdict(self, one: Candidate) -> bool | None:
        """Whether one of the sets of data accepts it; None where that is not known."""
        found = [self._known.get(f"{one.key} {at}") for at in range(len(self._sets))]
        if any(found[at] == whole for at, whole in enumerate(self._wholes)):
            return True
        return False if all(found[at] in places for at, places in enumerate(self._groups)) else None

    def is_right(self, base: Base) -> bool:
        """Whether all sets of data accept it."""
        for aimed, whole in zip(self._sets, self._wholes, strict=True):
            known = f"{original(base).key} {whole}"
            if known not in self._known and self.failing([base], aimed)[base]:
                return False
            self._known[known] = ""
        return True

    def judge(self, made: Sequence[Candidate]) -> None:
        """Find out the verdict of each; of a ladder none is judged below a few accepted rungs."""
        ladders: dict[str, list[Candidate]] = {}
        for each in made:
            ladders.setdefault(each.ladder or each.key, []).append(each)
        high, done = Counter[str](), 0
        while True:
            batch = []
            for name, rungs in ladders.items():
                few, enough = _NUMBERS if rungs and rungs[0].mutant.numbers[0] else _RUNGS
                if high[name] < enough:
                    batch += rungs[:few]
                    del rungs[:few]
            if not batch:
                return
            Random(0).shuffle(batch)  # some of every kind, should the time be up before the end
            for first in range(0, len(batch), _AT_ONCE):
                self._progress("judging mutants", done + first, len(made))
                self._judge(batch[first : first + _AT_ONCE])
            done += len(batch)
            high.update(each.ladder for each in batch if self.verdict(each))

    def _judge(self, some: Sequence[Candidate]) -> None:
        for number, aimed in enumerate(self._sets):
            left = [each for each in some if self.verdict(each) is None]
            left = [
                each for each in left if self._known.get(f"{each.key} {number}") not in self._groups[number]
            ]
            for first, last in pairwise((0, _FIRST, *range(_FIRST + _PART, len(aimed) + _PART, _PART))):
                asked, left = left, []
                for each, bad in self.wrong(asked, aimed[first:last], lambda *_: True):
                    if bad:
                        self._known[f"{each.key} {number}"] = aimed[first + bad[0]].place
                    elif last >= len(aimed):
                        self._known[f"{each.key} {number}"] = self._wholes[number]
                    else:
                        left.append(each)

    # -- cases -------------------------------------------------------------------------------------------

    def solved(self, case: Case) -> Tried | None:
        """What a valid case comes to, under 1.1 times the tolerance that most groups have.

        None for any other, for one that takes too long, and for one that is larger than all that are asked,
        where groups of larger ones are not: those may reject who is slow there, or wrong.
        """
        self._check_time()
        if items_of(case) > self._largest:
            return None
        found, group = None, self._usual
        with suppressed_after(_SOLVING), decisions() as told:
            exact = validate(self.problem, self.module, case)
            target = target_of(self.problem, within(exact, group.name), group.tolerance)
            gaps: dict[str, float] = {}
            for each in told:
                if each.gap:
                    gaps[each.what] = min(gaps.get(each.what, 1.0), abs(each.gap))
            found = Tried(case, target, group, exact=exact, gaps=gaps)
        for what, gap in found.gaps.items() if found else ():
            self._least[what] = min(self._least.get(what, _NEARLY), gap)
        return found

    def clear(self, found: Tried) -> bool:
        """Whether no decision is at the very edge of what is promised."""
        return all(gap >= min(_EDGE * self._least[what], _NEARLY) for what, gap in found.gaps.items())


def _mixed(data: ProblemData) -> list[Tried]:
    """The cases of its small groups, of each in turn, the shortest first."""
    rows = [
        (at, Tried(case, target, each.group, place))
        for each in data.groups
        if each.group.size is None
        for place in (hash_of(each),)
        for at, (case, target) in enumerate(zip(each.cases, each.targets, strict=True))
    ]
    return [each for _, each in sorted(rows, key=lambda row: (items_of(row[1].case), row[0]))]
