"""Holes in a kata's data: changed programs that they accept, and for each a valid case on which it is wrong.

What survives without such a case is right in another way, or nobody knows. Whatever was found is kept, so
that the next search goes on where this one ended: of a mutant the groups that rejected it, of a seed's
stream its place.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
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
from judge.holes.bench import SOURCE, Bench
from judge.holes.cases import Stream, Tried
from judge.holes.model import Hole, Holes, HoleSearch, Kept
from judge.holes.programs import Base, Candidate, bases
from judge.problem import Case, Problem
from judge.problem.solutions import MISTAKES
from judge.problem.toml import TomlFile
from judge.sandbox.boundary import LEVELS, BoxFactory, Stop
from judge.values import parameters
from judge.values.show import shown, wanted
from judge.verify.model import Fault, Progress, fault_of

MARKS = "same.toml"  # beside the folders of solutions: mutants that nobody wants to hold
_PROGRAMS = "no holes are looked for: it asks for programs, and has no function to change"
_UNJUDGED = "there was no time to judge all of its mutants; the same command goes on"
_TURNS = 16  # whose cases are asked at once, at most
_CALLS = 60_000  # … of all mutants
_ROUNDS = 20  # of steps to a shorter case
_SHORTER = 120  # cases that are tried for a shorter one in a round


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
    known, kept = store.read(name, key, dict[str, str]) or {}, store.read(own, key, Kept) or Kept()

    def keep() -> str | None:
        for at, what in ((name, known), (own, kept)):
            note = store.write(at, key, msgspec.json.encode(what), "searches for holes")
        return note

    with box_factory(SOURCE, "holes.py") as box:
        if box.isolation not in LEVELS[:2]:
            what = f"mutants need the isolation {' or '.join(LEVELS[:2])}, and here is {box.isolation}"
            raise UsageError(what, remedy="see 'judge doctor'")
        tell = progress or (lambda *_: None)
        return _Hunt(Bench(sets, box, known, tell), sets[0], search, kept, tell, keep).holes(programs)


def _line(candidate: Candidate) -> str:
    """A mutant in a line, `exact.py:7: a < b becomes a <= b`."""
    mutant = candidate.mutant
    place = f"{candidate.base.file}:{mutant.line}" if mutant.line else candidate.base.file
    was, becomes = (" ".join(each.split()) for each in (mutant.was, mutant.becomes))
    return f"{place}: {was} becomes {becomes}" if was else f"{place}: {becomes}"


class _Hunt(Struct):
    """One search: by mutant a case that shows it to be wrong, and right programs that fail."""

    bench: Bench
    data: ProblemData
    search: HoleSearch
    kept: Kept
    progress: Progress
    keep: Callable[[], str | None]
    found: dict[str, Tried] = {}
    faults: dict[str, Fault] = {}
    stopped: bool = False

    def holes(self, programs: Sequence[Base]) -> Holes:
        """All that was found."""
        problem, bench = self.data.problem, self.bench
        begun, seconds = monotonic(), self.search.seconds
        right = [each for each in programs if bench.is_right(each)]
        measured = problem.answer.measured or any(each.type.measured for each in problem.parameters)
        made = [*{each.key: each for base in right for each in base.mutants(measured)}.values()]
        bench.until, ended = begun + seconds / 2, False  # a first search has to judge them all
        try:
            bench.judge(made)
            ended = True
        except TimeoutError:
            pass
        finally:
            self.keep()
        bench.until = inf
        verdicts = [verdict for each in made if (verdict := bench.verdict(each)) is not None]
        accepted = [each for each in made if bench.verdict(each)]
        marked, stale = self._marked(made, accepted)
        left = [each for each in accepted if each.key not in marked]
        if left:
            self._look(right, left, begun + seconds)
        found = [each for each in left if self._clear(each)]
        unknown = [each for each in left if each.key not in self.found]
        return Holes(
            problem=problem.id,
            programs=len(right),
            mutants=len(verdicts),
            rejected=len(verdicts) - len(accepted),
            accepted=len(accepted),
            marked=len(marked),
            cases=self.kept.cases,
            holes=tuple(self._told(found, begun + seconds * 1.25)),  # for shorter cases
            edge=len(left) - len(found) - len(unknown),
            unknown=len(unknown),
            unwitnessed=tuple(sorted(map(_line, unknown))),
            faults=(*(stale if ended else ()), *self.faults.values()),
            notes=tuple(filter(None, [None if ended else f"{problem.id}: {_UNJUDGED}", self.keep()])),
            stopped=self.stopped,
        )

    def _clear(self, one: Candidate) -> bool:
        """Whether a case shows it to be wrong that is not at the very edge of the promise."""
        return one.key in self.found and self.bench.clear(self.found[one.key])

    def _marked(
        self, made: Sequence[Candidate], accepted: Sequence[Candidate]
    ) -> tuple[set[str], list[Fault]]:
        """The accepted mutants that same.toml marks, and what is wrong with its rows."""
        path = self.data.problem.solutions / MARKS
        if not path.exists() or self.search.program:
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

    def _look(self, right: Sequence[Base], left: Sequence[Candidate], end: float) -> None:
        """Try cases until the time is up, all are found to be wrong, or Ctrl-C is pressed."""
        kept, bench, search, begun = self.kept, self.bench, self.search, monotonic()
        known = [kept.witnesses[each.key] for each in left if each.key in kept.witnesses]
        again = [(bench.solved(ast.literal_eval(case)), way, row) for case, way, row in known]
        self._ask(right, left, [each._replace(way=way, row=row) for each, way, row in again if each])
        last = kept.cases + search.cases
        try:
            stream = Stream(self.data, bench.solved, search.seed, [*map(ast.literal_eval, kept.near)])
            while kept.cases < last and (asked := [each for each in left if not self._clear(each)]):
                self.progress("looking for holes", int(monotonic() - begun), int(search.seconds) + 1)
                batch, turns = list[Tried](), kept.turns
                while turns <= min(2 * kept.turns, kept.turns + _TURNS) and len(batch) * len(asked) < _CALLS:
                    batch += stream.turn(turns)
                    turns += 1
                stream.near += self._ask(right, asked, batch)
                kept.cases, kept.turns = kept.cases + len(batch), turns
                kept.near = [*map(repr, stream.near)]
                bench.until = end  # some are tried however late it is
        except TimeoutError:
            pass
        except KeyboardInterrupt:
            self.stopped = True
        bench.until = inf
        kept.witnesses = {key: (repr(each.case), each.way, each.row) for key, each in self.found.items()}

    def _ask(self, right: Sequence[Base], asked: Sequence[Candidate], batch: Sequence[Tried]) -> list[Case]:
        """Ask all of them; the cases that show something new."""
        bench, telling = self.bench, list[Case]()
        if not batch:
            return []
        clear = [*map(bench.clear, batch)]
        failing = bench.failing(right, batch)
        for base, failed in failing.items():
            for at in sorted(at for at in failed if clear[at])[:1]:
                tried = f"judge try {self.data.problem.id} {self._literal(batch[at].case)!r}"
                remedy = "correct it, or promise that there is no such case"
                self.faults.setdefault(
                    base.file, Fault(f"it is wrong on a valid case: {tried}", base.file, remedy)
                )

        def enough(one: Candidate, at: int) -> bool:
            return clear[at] and at not in failing[one.base]

        for one, places in bench.wrong(asked, batch, enough):
            wrong = sorted((not clear[at], at) for at in places if at not in failing[one.base])
            for edge, at in wrong[:1]:
                if not edge:
                    telling.append(batch[at].case)
                if not edge or one.key not in self.found:
                    self.found[one.key] = batch[at]
        return telling

    # -- what is told of them ----------------------------------------------------------------------------

    def _told(self, holes: Sequence[Candidate], end: float) -> Iterator[Hole]:
        """An entry for each of a few cases that show all of them, the one that shows most first."""
        bench, left = self.bench, {each.key: each for each in holes}
        found = list({repr(case): case for each in holes for case in [self.found[each.key]]}.values())
        found.sort(key=lambda each: measure(each.case))
        wrong = bench.shows(holes, found)
        while left:
            at = max(range(len(found)), key=lambda at: len(wrong[at] & left.keys()))
            members = [left[key] for key in left if key in wrong[at]]
            if not members:  # they answer otherwise each time
                break
            lead = min(members, key=lambda each: (each.mutant.kind == "tolerance", len(each.mutant.becomes)))
            ever = [found[at]]
            bench.until = end
            with suppress(TimeoutError):
                for each in self._shorter(lead, found[at]):
                    ever.append(each)
            bench.until = inf
            (gone,) = bench.shows([*left.values()], ever[-1:])
            left = {key: each for key, each in left.items() if key not in gone | {lead.key}}
            yield self._entry(lead, ever[-1], len(gone - {lead.key}))

    def _entry(self, lead: Candidate, found: Tried, others: int) -> Hole:
        answer, mutant = self.data.problem.answer, lead.mutant
        reply = self.bench.reply(lead, found.case)
        said = reply.detail.partition(" (line ")[0] or "no answer"  # the line is one of the box's own
        return Hole(
            file=lead.base.file,
            line=0 if lead.base.file.startswith(MISTAKES) else mutant.line,
            kind=mutant.kind,
            was=mutant.was,
            becomes=mutant.becomes,
            case=self._literal(found.case),
            right=wanted(answer, found.target),
            given=shown(answer, reply.answer) if reply.stop is Stop.ANSWERED else said,
            off=found.least if found.gaps else None,
            way=found.way,
            row=found.row,
            near=self._nearest(found.case),
            others=others,
        )

    def _shorter(self, lead: Candidate, found: Tried) -> Iterator[Tried]:
        """Ever simpler cases that show the same, clear of the edge."""
        problem, simpler, bench = self.data.problem, self.data.module.hooks.simpler, self.bench
        for _ in range(_ROUNDS):
            case, size = found.case, measure(found.case)
            tried = islice(
                chain(simpler(problem, case) if simpler else (), fewer(problem, case), steps(case)),
                4 * _SHORTER,
            )
            chosen = nsmallest(_SHORTER, (each for each in tried if measure(each) < size), key=measure)
            valid = [each for each in map(bench.solved, chosen) if each and bench.clear(each)]
            showing = (each for each, keys in zip(valid, bench.shows([lead], valid), strict=True) if keys)
            if (better := next(showing, None)) is None:
                return
            found = better._replace(way=found.way, row=found.row)
            yield found

    def _nearest(self, case: Case) -> str:
        """The case of the data that differs in the fewest arguments: where such a case belongs."""
        names, rows = [each.name for each in self.data.problem.parameters], list[tuple[int, str]]()
        for data in self.data.groups:
            for number, each in enumerate(data.cases if data.group.size is None else (), 1):
                differ = [name for name, a, b in zip(names, case, each, strict=True) if a != b]
                verb = "differs" if len(differ) == 1 else "differ"
                rows.append(
                    (len(differ), f"{data.group.name}, case {number} ({' and '.join(differ)} {verb})")
                )
        count, told = min(rows, key=lambda row: row[0])
        return told if count < len(names) else ""

    def _literal(self, case: Case) -> str:
        pairs = zip(self.data.problem.parameters, case, strict=True)
        return ", ".join(parameters.literal(each.type, value) for each, value in pairs)
