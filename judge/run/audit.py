"""The audit of a problem's data: of what kind there are how many cases, and of what kind none.

    numbers      the cases whose real numbers are all ints, all floats, or both; those near the smallest
    decisions    for everything that the answers turn on (`judge.problem.topic.Decision`), and each of its
                 sides, the cases by how far they are from there: by decade, and at the edges of the bands
    few          the wrong programs that hardly any case rejects

A bucket without a case is a gap, unless problem.toml gives a reason for it. Nothing is run here.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import floor, log10

from msgspec import Struct

from judge.data.model import GroupData
from judge.problem import Case, Parameter, Problem
from judge.problem.topic import Decision, Topic
from judge.run.matrix import Matrix

ENOUGH = 5  # cases that should reject a wrong program
NUMBERS = "numbers"
KINDS = ("all int", "all float", "mixed")
_NEAR_SMALLEST = 1000  # times the smallest number there may be
_INNER = (0.9, 1.0)  # of a band: its edge
_OUTER = (1.01, 3.0)  # of a promise


class Bucket(Struct, frozen=True):
    """One kind of case, how many there are, and why there need be none."""

    decision: str
    side: str
    range: str
    cases: int
    reason: str = ""

    @property
    def name(self) -> str:
        """As problem.toml writes it."""
        return ", ".join(part for part in (self.decision, self.side, self.range) if part)


class Few(Struct, frozen=True):
    """A wrong program that hardly any case rejects."""

    file: str
    cases: int


class Audit(Struct, frozen=True):
    """All of it; `types` counts, by group, the cases of each of `KINDS`, and is empty without real numbers.

    `idle` are the keys of problem.toml's `[audit]` that excuse no empty bucket.
    """

    types: Mapping[str, tuple[int, ...]]
    buckets: tuple[Bucket, ...]
    few: tuple[Few, ...]
    idle: tuple[str, ...]

    @property
    def gaps(self) -> tuple[Bucket, ...]:
        """The empty buckets that nothing excuses."""
        return tuple(bucket for bucket in self.buckets if not bucket.cases and not bucket.reason)


def audit(problem: Problem, topic: Topic, groups: Sequence[GroupData], matrix: Matrix | None) -> Audit:
    """Count the cases. Raises whatever the topic's own code raises."""
    cases = [case for data in groups for case in data.cases]
    types = _types(problem, groups)
    buckets = [*_numbers(problem, types, cases)]
    for decision in topic.decisions(problem) if topic.decisions else ():
        buckets += _buckets(decision, cases)
    used = {key for bucket in buckets if not bucket.cases for key in problem.audit if _covers(key, bucket)}
    return Audit(
        types=types,
        buckets=tuple(_excused(bucket, problem.audit) for bucket in buckets),
        few=tuple(_few(matrix) if matrix else ()),
        idle=tuple(key for key in problem.audit if key not in used),
    )


def _covers(key: str, bucket: Bucket) -> bool:
    """Whether a key names this bucket, or all those of its side or decision."""
    return bucket.name == key or bucket.name.startswith(f"{key}, ")


def _excused(bucket: Bucket, reasons: Mapping[str, str]) -> Bucket:
    reason = next((why for key, why in reasons.items() if _covers(key, bucket)), "")
    return bucket if bucket.cases else Bucket(bucket.decision, bucket.side, bucket.range, 0, reason)


def _few(matrix: Matrix) -> Iterator[Few]:
    for row in matrix.rows:
        rejecting = sum(len(kill.rejected) for kill in row.kills)
        if 0 < rejecting < ENOUGH:
            yield Few(row.file, rejecting)


# -- numbers ---------------------------------------------------------------------------------------------


def _types(problem: Problem, groups: Sequence[GroupData]) -> dict[str, tuple[int, ...]]:
    """The cases of each group whose numbers are all ints, all floats, or both."""
    places = [(at, each) for at, each in enumerate(problem.parameters) if _has_choice(each)]
    found = {}
    for data in groups if places else ():
        counts = Counter(_kind(places, case) for case in data.cases)
        found[data.group.name] = tuple(counts[kind] for kind in KINDS)
    return found


def _has_choice(parameter: Parameter) -> bool:
    """Whether its numbers may be ints or floats: an array of doubles has no choice."""
    return parameter.type.measured and not parameter.type.is_buffer


def _kind(places: Sequence[tuple[int, Parameter]], case: Case) -> str:
    types = {type(number) for at, parameter in places for number in parameter.type.reals(case[at])}
    if types == {int}:
        return "all int"
    return "all float" if types == {float} else "mixed" if types else ""


def _numbers(
    problem: Problem, types: Mapping[str, tuple[int, ...]], cases: Sequence[Case]
) -> Iterator[Bucket]:
    if types:
        for at, kind in enumerate(KINDS):
            yield Bucket(NUMBERS, kind, "", sum(counts[at] for counts in types.values()))
    fine = [(at, each, float(each.smallest)) for at, each in enumerate(problem.parameters) if each.smallest]
    if fine:
        near = sum(
            any(
                0 < abs(number) < _NEAR_SMALLEST * smallest
                for at, each, smallest in fine
                for number in each.type.reals(case[at])
            )
            for case in cases
        )
        yield Bucket(NUMBERS, "near the smallest", "", near)


# -- decisions -------------------------------------------------------------------------------------------


def _buckets(decision: Decision, cases: Sequence[Case]) -> Iterator[Bucket]:
    ranges = list(_ranges(decision))
    counts: Counter[tuple[str, str]] = Counter()
    for case in cases:
        counts.update(set(_places(decision, ranges, case)))
    for side in decision.sides:
        for label, _, _ in ranges:
            yield Bucket(decision.name, side, label, counts[side, label])


def _places(
    decision: Decision, ranges: Sequence[tuple[str, float, float]], case: Case
) -> Iterator[tuple[str, str]]:
    for side, share in decision.measure(case):
        yield from ((side, label) for label, low, high in ranges if low <= share <= high)


def _ranges(decision: Decision) -> Iterator[tuple[str, float, float]]:
    """The ranges of shares that are told apart: decades outside of the forbidden gap, and its edges."""
    within, beyond = decision.within, decision.beyond
    if decision.least is not None:
        low = round(log10(decision.least))
        for decade in range(low, floor(log10(decision.most) + 1e-9)):
            least, most = 10.0**decade, 10.0 ** (decade + 1)
            if within is None or beyond is None or most <= within * 1.001 or least >= beyond * 0.999:
                yield f"1e{decade} to 1e{decade + 1}", least, most
    if within is not None:
        yield _edge(within, *_INNER)
    if beyond is not None:
        yield _edge(beyond, *_OUTER)


def _edge(width: float, low: float, high: float) -> tuple[str, float, float]:
    return f"{low:g} to {high:g} times {width:g}", low * width, high * width * (1 + 1e-12)


def sides_of(buckets: Iterable[Bucket]) -> dict[tuple[str, str], list[Bucket]]:
    """The buckets by decision and side, in order."""
    found: dict[tuple[str, str], list[Bucket]] = {}
    for bucket in buckets:
        found.setdefault((bucket.decision, bucket.side), []).append(bucket)
    return found
