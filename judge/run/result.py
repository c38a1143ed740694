"""What judging one submission came to: frozen values whose fields are the keys of `--json` (schema 2)."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from enum import Enum
from itertools import pairwise
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from judge.errors import ExitCode
from judge.problem import Problem, Verdict
from judge.problem.model import KataLevel, Mode, case_of

if TYPE_CHECKING:
    from judge.values.outline import Outline
    from judge.values.wire import Raw

SCHEMA = 2
NO_ANSWER = "no answer"  # what is shown in place of one
_IMPORT_SECONDS = 0.02  # of CPU time, from which on an import is told of
_LONGEST = 4_000  # characters of an answer that is kept
_SETTLED = 0.25  # by which its exponent may differ between the smallest sizes and the largest ones
_SHORTEST = 1e-4  # seconds: what takes less cannot be told from nothing


class Answers(NamedTuple):
    """What a program answered wrongly in one group, by case from 0; before `reached` all is known."""

    reached: int
    wrong: Mapping[int, Outline]


Behaviour = Mapping[str, Answers]  # by the group's name
NOTHING: Behaviour = MappingProxyType({})


class GroupResult(Struct, frozen=True, kw_only=True):
    """One test group's outcome; `passed` counts accepted cases, `points` is what the group is worth.

    A group was not `run` where the program had been given up before; so many cases are `undecided` where it
    ended early, and where no answer was right or wrong. `worst_ulps` is the largest error of an
    accepted number, None where none was measured.
    """

    name: str
    verdict: Verdict
    cases: int
    passed: int
    points: int = 0
    level: KataLevel | None = None
    worst_ulps: float | None = None
    cpu_seconds: float = 0.0
    run: bool = True
    undecided: int = 0

    @property
    def score(self) -> int:
        """The points earned: all of them or none."""
        return self.points if self.verdict is Verdict.AC else 0


class LevelResult(Struct, frozen=True):
    """How far a submission came on one level: of its `groups`, so many were `run` and so many `accepted`.

    It is `passed` where every group of the level was run and accepted.
    """

    level: KataLevel
    passed: bool
    groups: int
    run: int
    accepted: int


class Failure(Struct, frozen=True):
    """One failing case, or why nothing could be run (then only `message` is set).

    `group` is the test group whose tolerance decides, `case` counts from 1 within it; None where it holds no
    such case. `input` maps a parameter's name to its value, `shown` is the case where it is not shown by its
    arguments: what a program read in a format of the kata's own, or calls in a row. `given` is the answer in
    its JSON form where it is short, `printed` what the function printed meanwhile. `where` says which part is
    wrong; `absolute`, `relative` and `ulps` are its errors where it is a number. `replay` is the id to judge
    just this case by; the search for a smallest case was `cut_short` where it had not come to its end.
    """

    message: str
    group: str | None = None
    case: int | None = None
    input: dict[str, Any] | None = None
    expected: str | None = None
    got: str | None = None
    given: Any = None
    printed: str = ""
    shown: str = ""
    where: str = ""
    absolute: float | None = None
    relative: float | None = None
    ulps: float | None = None
    replay: str | None = None
    cut_short: bool = False


def short_answer(given: Raw) -> Raw:
    """The answer as it was sent, for a `Failure`: a program's numbers as doubles.

    None for a long one, and for one that holds what no JSON of ours can: half of a surrogate pair.
    """
    try:
        text = json.dumps(given, allow_nan=False, default=lambda written: written.approx, ensure_ascii=False)
        text.encode()
    except (ValueError, RecursionError):  # an infinite number, or a list in itself
        return None
    return json.loads(text) if len(text) <= _LONGEST else None


class Ratio(Struct, frozen=True):
    """CPU time as a multiple of the reference solution's, over interleaved pairs of runs.

    `low` and `high` are the quartiles, `limit` is what the median is held to. `unreliable` says why the
    figure deserves no belief ("too short", "too noisy"); `busy` says what else the machine did meanwhile.
    """

    median: float
    low: float
    high: float
    pairs: int
    limit: float = 0.0
    unreliable: str = ""
    busy: str = ""


class GrowthPoint(Struct, frozen=True):
    """The CPU seconds of one case; the submission takes so many at least, where it has not `ended`."""

    group: str
    size: int
    cpu_seconds: float
    reference_seconds: float
    ended: bool = True


class Growth(Struct, frozen=True):
    """How CPU time grows with n: `exponent` is the submission's, `reference` that of the reference solution.

    `slope` is by how much the first may exceed the second, `groups` are those that the exponents are of, and
    `pairs` how many interleaved pairs of runs the widest of them had. `points` are all that took long enough,
    by size.
    """

    exponent: float
    reference: float
    slope: float
    groups: tuple[str, ...]
    pairs: int
    borderline: bool = False
    points: tuple[GrowthPoint, ...] = ()

    def __str__(self) -> str:
        return f"it grows {self.law}, the reference like n^{self.reference:.1f}"

    @property
    def too_steep(self) -> str:
        """Why a submission that grows so is rejected."""
        return f"{self}; its exponent may exceed that by {self.slope:g}"

    @property
    def law(self) -> str:
        """`like n^2.0`; `at least` like that where it was stopped on a size, or still grows ever faster."""
        points = [point for point in self.points if point.group in self.groups]
        took = [(point.size, point.cpu_seconds) for point in points]
        steps = [exponent(pair) for pair in pairwise(took) if pair[0][0] < pair[1][0]]
        if all(point.ended for point in points) and (not steps or steps[-1] <= steps[0] + _SETTLED):
            return f"like n^{self.exponent:.1f}"
        return f"at least like n^{math.floor(self.exponent * 10) / 10:.1f}"


def exponent(points: Sequence[tuple[int, float]]) -> float:
    """The e of the law y = c·nᵉ that fits the points (n, y) best; of n at least two must differ."""
    xs = [math.log(size) for size, _ in points]
    ys = [math.log(max(value, _SHORTEST)) for _, value in points]
    x_mean, y_mean = math.fsum(xs) / len(xs), math.fsum(ys) / len(ys)
    over = math.fsum((x - x_mean) * (y - y_mean) for x, y in zip(xs, ys, strict=True))
    return over / math.fsum((x - x_mean) ** 2 for x in xs)


class Timing(Struct, frozen=True, kw_only=True):
    """What a submission used in all its groups; `borderline` says the time limit was a close call.

    `import_seconds` is the CPU time of a function's import, which `ratio` leaves out. `reference` is the
    language of the reference that a submission in another language than Python was raced with, and `why` says
    why that is another one than its own.
    """

    cpu_seconds: float = 0.0
    wall_seconds: float = 0.0
    import_seconds: float = 0.0
    ratio: Ratio | None = None
    borderline: bool = False
    growth: Growth | None = None
    reference: str = ""
    why: str = ""

    @property
    def import_tells(self) -> bool:
        """Whether the import takes so long that a person should know."""
        return self.import_seconds >= _IMPORT_SECONDS


class Taken(Struct, frozen=True):
    """CPU seconds of one case, and as a multiple of the first program's; None where `why_not` says why."""

    seconds: float | None = None
    ratio: float | None = None
    why_not: str = ""


class MistakeStep(Struct, frozen=True):
    """A change of the program that was tried: `gone` of the `of` failures go with it.

    `name` is the mistake's where that is sure, `kind` the sort of change, `line` where it is, 0 where it has
    no line. `why` says what was seen there.
    """

    name: str | None
    kind: str
    line: int
    gone: int
    of: int
    why: str = ""


class Pitfall(Struct, frozen=True):
    """The mistake that explains the wrong answers, or the two together; `score` is between 0 and 1.

    `advice` says of each what is wrong. `perhaps` is empty: results of before may have another mistake in it.
    `steps` are what was proved, the largest first: all that is known where there is no name. Where the work
    lies in a `library`, nothing of its source is known.
    """

    names: tuple[str, ...]
    score: float
    advice: tuple[str, ...]
    perhaps: tuple[str, ...] = ()
    steps: tuple[MistakeStep, ...] = ()
    library: bool = False

    @property
    def name(self) -> str:
        """The mistake's name, or the two as "a + b"."""
        return " + ".join(self.names)


class EntryKind(Enum):
    """Why a submission can answer nothing at all, whatever the case."""

    STUB = "stub"  # the entry function is still to be written
    NO_CLASS = "no class"  # the entry is a function where a class is asked for
    ARITY = "arity"  # the entry function takes another number of arguments
    MODULE = "module"  # a module that it imports is not there
    IMPORT = "import"  # an exception ends its import
    NESTED = "nested"  # the entry function stands in a class or another function
    MISNAMED = "misnamed"  # there is a name like the entry function's
    TEXT = "text"  # its definition stands in a text
    COMMENT = "comment"  # or in a comment
    EMPTY = "empty"  # nothing but comments is in the file
    NO_ENTRY = "no entry"  # there is no entry function, and nothing is read


class EntryError(Struct, frozen=True):
    """An obstacle in `line` of the file, 0 where it has none.

    `name` is the module, the name that is like the entry's, or the "print" that is there; `takes` says how
    many arguments it takes, `within` what a function stands in: "class Solution", "function main".
    """

    kind: EntryKind
    line: int = 0
    name: str = ""
    takes: str = ""
    within: str = ""


class Result(Struct, frozen=True, kw_only=True):
    """The outcome of one submission on one problem: `as_json()` is what `judge run --json` writes.

    The verdict is that of the first failing group; `groups` is empty where nothing could be run (CE, JE).
    `score` sums the points of the accepted groups, `points` those of all groups that were run: 100 unless
    some were left out. `levels` are those of the problem, the easier first; none where it has none, or
    nothing could be run. `failure` is the first failing case, `counterexample` the smallest one that was
    found, `pitfall` the mistake behind them; a `hurdle` keeps a submission from running at all. `isolation`
    is the level it was held at. `notes` are sentences for the person about what did not go as it should
    beside the verdict. `out_of` is how many groups the problem has, 0 where all were run. It was `cut_short`
    where a bound by the clock kept something from being called, searched for or named.
    """

    schema: int = SCHEMA
    problem: str
    submission: str
    mode: Mode = Mode.FUNCTION
    verdict: Verdict
    score: int = 0
    points: int = 0
    levels: tuple[LevelResult, ...] = ()
    groups: tuple[GroupResult, ...] = ()
    failure: Failure | None = None
    counterexample: Failure | None = None
    pitfall: Pitfall | None = None
    hurdle: EntryError | None = None
    time: Timing = Timing()
    memory_bytes: int = 0
    isolation: str = ""
    notes: tuple[str, ...] = ()
    out_of: int = 0
    cut_short: bool = False

    def __repr__(self) -> str:
        """One line: who did what, and how it ended."""
        where = f", in {self.failure.group}" if self.failure and self.failure.group else ""
        named = f", {self.pitfall.name}" if self.pitfall and self.pitfall.names else ""
        points = f"{self.score} of {self.points} points"
        return f"<Result {self.problem} {self.submission}: {self.verdict.value}, {points}{where}{named}>"

    @property
    def partial(self) -> str:
        """`1 of 18 groups` where some were left out by request, else nothing."""
        return f"{len(self.groups)} of {self.out_of} groups" if self.out_of else ""

    @property
    def solved(self) -> bool:
        """Whether it was accepted with no group left out."""
        return self.verdict is Verdict.AC and not self.out_of

    def noting(self, *notes: str) -> Result:
        """The same with more notes; none stands twice."""
        return replace(self, notes=tuple(dict.fromkeys((*self.notes, *notes)))) if notes else self

    def typed(self, problem: Problem) -> Result:
        """The same with its cases as the problem has them, where JSON has made lists of points."""
        cases = (self.failure, self.counterexample)
        first, small = (
            replace(each, input=problem.named(case_of(each.input))) if each and each.input else each
            for each in cases
        )
        return replace(self, failure=first, counterexample=small)

    @property
    def exit_code(self) -> ExitCode:
        """What this result alone tells the shell."""
        if self.verdict is Verdict.AC:
            return ExitCode.ACCEPTED
        return ExitCode.FAULT if self.verdict is Verdict.JE else ExitCode.NOT_ACCEPTED

    def as_json(self) -> dict[str, Any]:
        """The object that `judge run --json` writes."""
        plain: dict[str, Any] = json.loads(json.dumps(msgspec.to_builtins(self)))  # with lists for tuples
        return plain


def judge_fault(problem: str, submission: str, message: str) -> Result:
    """The result of a submission that could not be judged through the judge's or the problem's own fault."""
    return Result(problem=problem, submission=submission, verdict=Verdict.JE, failure=Failure(message))


def earned(groups: Sequence[GroupResult]) -> dict[str, Any]:
    """The groups with what they sum up to, as fields of a `Result`."""
    return {
        "groups": tuple(groups),
        "score": sum(group.score for group in groups),
        "points": sum(group.points for group in groups),
    }


def exit_code(results: Iterable[Result]) -> ExitCode:
    """What several results together tell the shell: the judge's fault weighs most, then a rejection."""
    return max((result.exit_code for result in results), default=ExitCode.ACCEPTED)
