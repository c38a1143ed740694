"""Holes in a kata's data: changed programs that they accept, and for each a valid case on which it is wrong.

What survives without such a case is right in another way, or nobody knows. Whatever was found is kept, so
that the next search goes on where this one ended: of a mutant the groups that rejected it, of a seed's
stream its place.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from heapq import nsmallest
from itertools import chain, islice
from math import inf
from time import monotonic

import msgspec
from msgspec import Struct

from judge.cache import Store, code_key
from judge.data import ProblemData
from judge.data.load import kept_place
from judge.diagnose.candidates import measure
from judge.diagnose.simplify import fewer, steps
from judge.errors import ProblemError, UsageError
from judge.holes.bench import Bench
from judge.holes.cases import FoundCase, Stream, StreamState
from judge.holes.model import Hole, Holes, HoleSearch, Kept, KnownMutants
from judge.holes.programs import SOURCE, Base, Candidate, Candidates, bases
from judge.problem import Case, Problem
from judge.problem.solutions import MISTAKES
from judge.problem.toml import TomlFile
from judge.sandbox.boundary import LEVELS, BoxFactory, Reply, Stop
from judge.values import parameters
from judge.values.show import shown, wanted
from judge.verify.model import Fault, Progress, fault_of

MARKS = "same.toml"  # beside the folders of solutions: mutants that nobody wants to hold
_PROGRAMS = "no holes are looked for: it asks for programs, and has no function to change"
_UNJUDGED = "there was no time to judge all of its mutants; the same command goes on"
_SAVED = 5.0  # seconds between two times that a search is kept
_TURNS = 64  # of a batch of cases, at most
_SECONDS = 4  # of CPU that a batch of cases may take
_ROUNDS = 20  # of steps to a shorter case
_SHORTER = 120  # cases that are tried for a shorter one in a round
_MOST_SHOWN = 64  # witnesses of which the fewest are chosen


class SameRow(Struct, frozen=True, forbid_unknown_fields=True):
    """A row of same.toml: a change after which the program is right as well; … stands for anything."""

    file: str
    was: str
    becomes: str
    why: str

    def marks(self, candidate: Candidate) -> bool:
        """Whether it is this change."""
        mutant = candidate.mutant
        wanted = ".*".join(map(re.escape, self.becomes.split("…")))
        same = (self.file, self.was) == (candidate.base.file, mutant.was)
        return same and re.fullmatch(wanted, mutant.becomes, re.DOTALL) is not None


class _Marks(Struct, frozen=True, forbid_unknown_fields=True):
    same: tuple[SameRow, ...] = ()


def look_for_holes(
    problem: Problem,
    sets: Sequence[ProblemData],
    box_factory: BoxFactory,
    search: HoleSearch,
    store: Store,
    progress: Progress | None = None,
) -> Holes:
    """Change right programs, and look for cases on which those are wrong that one of the `sets` accepts.

    Ctrl-C ends the search, and what was found is returned. Raises UsageError where mutants cannot be held
    well enough, JudgeError where nothing can be run, ProblemError where the kata is broken.
    """
    if not problem.parameters:  # there is nothing to try
        return Holes(problem.id)
    programs = bases(problem, search.program)
    if not problem.entry:
        return Holes(problem.id, notes=(f"{problem.id}: {_PROGRAMS}",))
    if not programs:
        kind = "class" if problem.methods else "function"
        remedy = f"write a {kind} {problem.entry} in Python into accepted"
        fault = Fault("no accepted program can be changed", f"{problem.solutions.name}/accepted", remedy)
        return Holes(problem.id, faults=(fault,))
    name, key = kept_place("holes", problem, None)[0], code_key("holes")
    own = f"{name}-{search.seed}"
    judged = store.read(name, key, KnownMutants) or KnownMutants()
    kept = store.read(own, key, Kept) or Kept()

    def keep() -> str | None:
        for at, what in ((name, judged), (own, kept)):
            note = store.write(at, key, msgspec.json.encode(what), "searches for holes")
        return note

    with box_factory(SOURCE, "holes.py") as box:
        if box.isolation not in LEVELS[:2]:
            what = f"mutants need the isolation {' or '.join(LEVELS[:2])}, and here is {box.isolation}"
            raise UsageError(what, remedy="see 'judge doctor'")
        tell = progress or (lambda *_: None)
        bench = Bench(problem, sets, Candidates(problem, box), judged, tell)
        return _Hunt(bench, sets[0], search, kept, tell, keep).holes(programs)


def _line(candidate: Candidate) -> str:
    """A mutant in a line, `exact.py:7: a < b becomes a <= b`."""
    mutant = candidate.mutant
    place = f"{candidate.base.file}:{mutant.line}" if mutant.line else candidate.base.file
    was, becomes = (" ".join(each.split()) for each in (mutant.was, mutant.becomes))
    return f"{place}: {was} becomes {becomes}" if was else f"{place}: {becomes}"


def _said(reply: Reply) -> str:
    """What ended a call; the line is one of the box's own."""
    return reply.detail.partition(" (line ")[0] or "no answer"


class _Hunt:
    """One search; `found` and `edge` are by mutant, `faults` are right programs that fail."""

    def __init__(
        self,
        bench: Bench,
        data: ProblemData,
        search: HoleSearch,
        kept: Kept,
        progress: Progress,
        keep: Callable[[], str | None],
    ) -> None:
        self._bench, self._problem, self._data = bench, data.problem, data
        self._search, self._kept, self._progress = search, kept, progress
        self._found: dict[str, FoundCase] = {}
        self._edge: dict[str, FoundCase] = {}
        self._faults: dict[str, Fault] = {}
        self._stopped = False
        self._keep = keep

    def holes(self, programs: Sequence[Base]) -> Holes:
        """All that was found."""
        problem, answer = self._problem, self._problem.answer
        begun, seconds = monotonic(), self._search.seconds
        right = [each for each in programs if self._bench.is_right(each)]
        measured = answer.measured or any(each.type.measured for each in problem.parameters)
        made = {each.key: each for base in right for each in base.mutants(measured)}
        self._bench.until = begun + seconds / 2  # a first search has to judge them all
        try:
            accepted, count, ended = self._bench.judged([*made.values()])
        finally:
            self._keep()
        marked, stale = self._marked([*made.values()], accepted)
        keys = {each.key for each in accepted} - marked
        left = {key: each for key, each in made.items() if key in keys}  # in an order of their own
        if left:
            self._bench.until = begun + seconds
            self._look(right, left)
        wrong = [each for key, each in left.items() if key in self._found]
        self._bench.until = inf
        keys = {each.key for each in self._bench.accepted(wrong)}
        found = {each.key: each for each in wrong if each.key in keys}
        rejected = count - len(accepted) + len(wrong) - len(found)
        unknown = [each for key, each in left.items() if key not in self._found | self._edge]
        self._bench.until = begun + seconds * 1.25  # for shorter cases
        return Holes(
            problem=problem.id,
            programs=len(right),
            mutants=count,
            rejected=rejected,
            accepted=count - rejected,
            marked=len(marked),
            cases=self._kept.cases,
            holes=tuple(self._told(found)),
            edge=len(self._edge),
            unknown=len(unknown),
            unwitnessed=tuple(sorted(map(_line, unknown))),
            faults=(*(stale if ended else ()), *self._faults.values()),
            notes=tuple(filter(None, [None if ended else f"{problem.id}: {_UNJUDGED}", self._keep()])),
            stopped=self._stopped,
        )

    # -- marks -------------------------------------------------------------------------------------------

    def _marked(
        self, made: Sequence[Candidate], accepted: Sequence[Candidate]
    ) -> tuple[set[str], list[Fault]]:
        """The accepted mutants that same.toml marks, and what is wrong with its rows."""
        path = self._problem.solutions / MARKS
        if not path.exists() or self._search.program:
            return set(), []
        try:
            file = TomlFile(path)
            rows = file.read(_Marks).same
        except ProblemError as fault:
            return set(), [fault_of(fault, MARKS)]
        marked, faults = set[str](), []
        for at, mark in enumerate(rows):
            keys = {each.key for each in accepted if mark.marks(each)}
            marked |= keys
            if not keys:
                there = any(mark.marks(each) for each in made)
                what = "this mutant is rejected now" if there else "no mutant is like this"
                faults.append(Fault(what, file.place(("same", at)), "remove the row"))
        return marked, faults

    # -- cases on which they are wrong -------------------------------------------------------------------

    def _look(self, right: Sequence[Base], left: Mapping[str, Candidate]) -> None:
        """Try cases until the time is up, all are found to be wrong, or Ctrl-C is pressed."""
        kept, bench, search = self._kept, self._bench, self._search
        place = StreamState(kept.turns, kept.tried, [ast.literal_eval(each) for each in kept.near])
        stream = Stream(self._data, bench.solved, search.seed, place)
        rows = [kept.witnesses[key] for key in left if key in kept.witnesses]
        begun = saved = monotonic()
        self._ask(right, left, [FoundCase(ast.literal_eval(case), way, row) for case, way, row in rows])
        last = kept.cases + search.cases
        try:
            while len(self._found) < len(left) and kept.cases < last and not bench.late:
                now = monotonic()
                if now > saved + _SAVED:  # who is killed has lost no more than this
                    saved = now
                    self._keep_place(place)
                self._progress("looking for holes", int(now - begun), int(search.seconds) + 1)
                batch: list[FoundCase] = []
                asked = len(left) - len(self._found)
                for each in chain.from_iterable(stream.turn() for _ in range(_TURNS)):
                    if bench.late or len(batch) * asked >= _SECONDS * bench.crowd.most:
                        break
                    if bench.solved(each.case) is not None:
                        batch.append(each)
                if not batch:
                    break
                kept.cases += len(batch)
                place.near += self._ask(right, left, batch)
        except KeyboardInterrupt:
            self._stopped = True
        for key, each in [*self._edge.items()]:  # the edge is where the least gaps are, and those come late
            solved = bench.solved(each.case)
            if key in self._found or (solved is not None and bench.clear(solved)):
                self._found.setdefault(key, each)
                del self._edge[key]
        self._keep_place(place)

    def _ask(
        self, right: Sequence[Base], left: Mapping[str, Candidate], batch: Sequence[FoundCase]
    ) -> list[Case]:
        """Ask all that are not found wrong yet; the cases that show something new."""
        bench = self._bench
        pairs = [(each, solved) for each in batch if (solved := bench.solved(each.case)) is not None]
        if not pairs:
            return []
        aimed = [bench.aimed(each.case, solved) for each, solved in pairs]
        clear = [bench.clear(solved) for _, solved in pairs]
        failing = {base.file: bench.failing(base, aimed) for base in right}
        for file, failed in failing.items():
            bad = next((at for at in sorted(failed) if clear[at]), None)
            if bad is not None:
                tried = f"judge try {self._problem.id} {self._literal(aimed[bad].case)!r}"
                remedy = "correct it, or promise that there is no such case"
                self._faults.setdefault(file, Fault(f"it is wrong on a valid case: {tried}", file, remedy))
        asked = [each for key, each in left.items() if key not in self._found]
        telling: list[Case] = []
        size = bench.crowd.most // len(aimed) + 1
        for first in range(0, len(asked), size):
            part = asked[first : first + size]
            for candidate, places in zip(part, bench.wrong(part, aimed), strict=True):
                wrong = [at for at in places if at not in failing[candidate.base.file]]
                at = next((at for at in wrong if clear[at]), None)
                if at is not None:
                    self._found[candidate.key] = pairs[at][0]
                    telling.append(aimed[at].case)
                elif wrong:
                    self._edge.setdefault(candidate.key, pairs[wrong[0]][0])
        return telling

    # -- what is told of them ----------------------------------------------------------------------------

    def _told(self, holes: Mapping[str, Candidate]) -> Iterator[Hole]:
        """An entry for each of a few cases that show all of them, the one that shows most first."""
        cases = list({repr(self._found[key].case): self._found[key] for key in holes}.values())
        cases = sorted(cases, key=lambda each: measure(each.case))[:_MOST_SHOWN]
        wrong = self._bench.shows(holes, [each.case for each in cases])
        left = dict(holes)
        while left:
            at = max(range(len(cases)), key=lambda each: len(wrong[each] & left.keys()))
            members, found = [left[key] for key in left if key in wrong[at]], cases[at]
            if not members:  # its case is beyond those that were compared
                members = [next(iter(left.values()))]
                found = self._found[members[0].key]
            lead = min(members, key=lambda each: (each.mutant.kind == "tolerance", len(each.mutant.becomes)))
            short = self._shorter(lead, found.case)
            gone = {lead.key} | self._bench.shows(left, [short])[0]
            left = {key: each for key, each in left.items() if key not in gone}
            yield self._entry(lead, found, short, len(gone) - 1)

    def _entry(self, lead: Candidate, found: FoundCase, case: Case, others: int) -> Hole:
        solved = self._bench.solved(case)
        assert solved is not None  # it was valid before
        reply = next(self._bench.crowd.answers([(lead, [case])]))[0]
        answer, mutant = self._problem.answer, lead.mutant
        given = shown(answer, reply.answer) if reply.stop is Stop.ANSWERED else _said(reply)
        return Hole(
            file=lead.base.file,
            line=0 if lead.base.file.startswith(MISTAKES) else mutant.line,
            kind=mutant.kind,
            was=mutant.was,
            becomes=mutant.becomes,
            case=self._literal(case),
            right=wanted(answer, self._bench.aimed(case, solved).target),
            given=given,
            off=solved.least if solved.gaps else None,
            way=found.way,
            row=found.row,
            near=self._nearest(case),
            others=others,
        )

    def _shorter(self, lead: Candidate, case: Case) -> Case:
        """A simpler case that shows the same, clear of the edge."""
        simpler = self._data.module.hooks.simpler
        for _ in range(_ROUNDS):
            if self._bench.late:
                break
            own, size = simpler(self._problem, case) if simpler else (), measure(case)
            tried = islice(chain(own, fewer(self._problem, case), steps(case)), 4 * _SHORTER)
            chosen = nsmallest(_SHORTER, (each for each in tried if measure(each) < size), key=measure)
            pairs = [(each, self._bench.solved(each)) for each in chosen]
            valid = [each for each, solved in pairs if solved and self._bench.clear(solved)]
            showing = zip(valid, self._bench.shows({lead.key: lead}, valid), strict=True)
            better = next((each for each, keys in showing if keys), None)
            if better is None:
                break
            case = better
        return case

    def _nearest(self, case: Case) -> str:
        """The case of the data that differs in the fewest arguments: where such a case belongs."""
        names = [each.name for each in self._problem.parameters]
        best: tuple[int, str] = len(names) + 1, ""
        for data in self._data.groups:
            for number, each in enumerate(data.cases if data.group.size is None else (), 1):
                differ = [name for name, a, b in zip(names, case, each, strict=True) if a != b]
                if len(differ) < best[0]:
                    verb = "differs" if len(differ) == 1 else "differ"
                    best = len(differ), f"{data.group.name}, case {number} ({' and '.join(differ)} {verb})"
        return best[1] if best[0] < len(names) else ""

    def _literal(self, case: Case) -> str:
        pairs = zip(self._problem.parameters, case, strict=True)
        return ", ".join(parameters.literal(each.type, value) for each, value in pairs)

    def _keep_place(self, place: StreamState) -> None:
        found = self._edge | self._found
        self._kept.near = [repr(each) for each in place.near]
        self._kept.witnesses = {key: (repr(each.case), each.way, each.row) for key, each in found.items()}
        self._keep()
