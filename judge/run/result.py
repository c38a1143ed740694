"""What judging one submission came to: frozen values, ready to be shown or written as JSON.

`Result.as_json()` is the published object (schema 1); the attributes hold a little more for the screen, such
as a group's points and how far off an answer was.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from judge.errors import ExitCode
from judge.problem import Verdict
from judge.problem.model import KataLevel

if TYPE_CHECKING:
    from judge.values import Outline, Raw

SCHEMA = 1
_IMPORT_SECONDS = 0.02  # of CPU time, from which on an import is told of


class Mode(Enum):
    """How a submission was run; the value is its name in JSON."""

    FUNCTION = "function"  # its entry function was called
    PROGRAM = "program"  # it read stdin and wrote stdout


class GroupResult(Struct, frozen=True):
    """One test group's outcome; `passed` counts accepted cases, `points` is what the group is worth.

    `wrong` holds the cases that were run and not accepted, counted from 0, and what was given there. Those
    before `reached` have all been decided; a case beyond it was not decided unless it is in `wrong`.
    """

    name: str
    verdict: Verdict
    cases: int
    passed: int
    worst_ulps: float | None  # the largest error of an accepted number, None where none was measured
    cpu_seconds: float
    points: int = 0
    reached: int = 0
    wrong: Mapping[int, Outline] = {}
    level: KataLevel | None = None

    @property
    def score(self) -> int:
        """The points earned: all of them or none."""
        return self.points if self.verdict is Verdict.AC else 0

    def as_json(self) -> dict[str, Any]:
        """The group's object in the published form."""
        own: dict[str, Any] = {
            "name": self.name,
            "verdict": self.verdict.value,
            "cases": self.cases,
            "passed": self.passed,
            "worst_ulps": self.worst_ulps,
            "cpu_seconds": self.cpu_seconds,
        }
        return own | ({"level": self.level.value} if self.level else {})


class LevelResult(Struct, frozen=True):
    """How far a submission came on one level: of its `groups`, so many were `run` and so many `accepted`."""

    level: KataLevel
    groups: int
    run: int
    accepted: int

    @property
    def passed(self) -> bool:
        """Whether every group of the level was run and accepted."""
        return self.accepted == self.groups

    def as_json(self) -> dict[str, Any]:
        """The level's object in the published form."""
        return {
            "level": self.level.value,
            "passed": self.passed,
            "groups": self.groups,
            "run": self.run,
            "accepted": self.accepted,
        }


class Failure(Struct, frozen=True):
    """The first failing case, or why nothing could be run (then only `message` is set).

    `case` counts from 1 within its group. `input` maps a parameter's name to its value.
    `where` says which part is wrong; `absolute`, `relative` and `ulps` are its errors where it is a number.
    `given` is the answer itself, as the submission sent it; None where there is none. `printed` is what the
    function printed meanwhile, a few printable lines; it is in the JSON only where there is something.
    """

    message: str
    group: str | None = None
    case: int | None = None
    input: dict[str, Any] | None = None
    expected: str | None = None
    got: str | None = None
    where: str = ""
    absolute: float | None = None
    relative: float | None = None
    ulps: float | None = None
    given: Raw = None
    printed: str = ""

    def as_json(self) -> dict[str, Any]:
        """The failure's object in the published form."""
        found = {
            "group": self.group,
            "case": self.case,
            "input": self.input,
            "expected": self.expected,
            "got": self.got,
            "message": self.message,
        }
        return found | ({"printed": self.printed} if self.printed else {})


class Ratio(Struct, frozen=True):
    """CPU time as a multiple of the reference solution's, over interleaved pairs of runs.

    `low` and `high` are the quartiles. `unreliable` says why the figure deserves no belief ("too short",
    "too noisy"); it is empty, and not in the JSON, where it does. `busy` says what else the machine did
    meanwhile, in the same way.
    """

    median: float
    low: float
    high: float
    pairs: int
    unreliable: str = ""
    busy: str = ""

    def as_json(self) -> dict[str, Any]:
        """The ratio's object in the published form."""
        figures: dict[str, Any] = {
            "median": self.median,
            "low": self.low,
            "high": self.high,
            "pairs": self.pairs,
        }
        doubts = {"unreliable": self.unreliable, "busy": self.busy}
        return figures | {name: why for name, why in doubts.items() if why}


class Against(Struct, frozen=True):
    """Whose time a submission in another language than Python is a multiple of.

    That of the reference in `language`; `why` says why that is another one than its own.
    """

    language: str
    why: str = ""

    def as_json(self) -> dict[str, Any]:
        """The object in the published form."""
        return {"language": self.language} | ({"why": self.why} if self.why else {})


class GrowthPoint(Struct, frozen=True):
    """The CPU seconds of one case; the submission takes so many at least, where it has not `ended`."""

    group: str
    size: int
    seconds: float
    reference: float
    ended: bool = True

    def as_json(self) -> dict[str, Any]:
        """The point's object in the published form."""
        return {
            "group": self.group,
            "size": self.size,
            "cpu_seconds": self.seconds,
            "reference_seconds": self.reference,
            "ended": self.ended,
        }


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
        return f"it grows like n^{self.exponent:.1f}, the reference like n^{self.reference:.1f}"

    def as_json(self) -> dict[str, Any]:
        """The growth's object in the published form."""
        return {
            "exponent": self.exponent,
            "reference": self.reference,
            "slope": self.slope,
            "groups": list(self.groups),
            "pairs": self.pairs,
            "borderline": self.borderline,
            "points": [point.as_json() for point in self.points],
        }


class Timing(Struct, frozen=True):
    """What a submission used in all its groups; `borderline` says the time limit was a close call.

    `growth` is there, and in the JSON, only where the problem has a rule of growth. `import_seconds` is the
    CPU time of a function's import, which `ratio` leaves out; in the JSON where it is worth a word. `against`
    is there, and in the JSON, where a submission in another language than Python was raced.
    """

    cpu_seconds: float = 0.0
    wall_seconds: float = 0.0
    ratio: Ratio | None = None
    borderline: bool = False
    growth: Growth | None = None
    import_seconds: float = 0.0
    against: Against | None = None

    @property
    def import_tells(self) -> bool:
        """Whether the import takes so long that a person should know."""
        return self.import_seconds >= _IMPORT_SECONDS

    def as_json(self) -> dict[str, Any]:
        """The timing's object in the published form."""
        figures: dict[str, Any] = {
            "cpu_seconds": self.cpu_seconds,
            "wall_seconds": self.wall_seconds,
            "ratio": self.ratio.as_json() if self.ratio else None,
            "borderline": self.borderline,
        }
        if self.import_tells:
            figures["import_seconds"] = self.import_seconds
        if self.against:
            figures["reference"] = self.against.as_json()
        return figures | ({"growth": self.growth.as_json()} if self.growth else {})


class Pitfall(Struct, frozen=True):
    """The mistake that explains the wrong answers, or the two together; `score` is between 0 and 1.

    `advice` says of each what is wrong and what to do instead. `perhaps` is another mistake that explains
    them nearly as well, if there is one. `lines` are those that programs with the mistake have, each
    with what a right program has there; either may be empty.
    """

    names: tuple[str, ...]
    score: float
    advice: tuple[str, ...]
    perhaps: tuple[str, ...] = ()
    lines: tuple[tuple[str, str], ...] = ()

    @property
    def name(self) -> str:
        """The mistake's name, or the two as "a + b"."""
        return " + ".join(self.names)

    def as_json(self) -> dict[str, Any]:
        """The pitfall's object in the published form."""
        found: dict[str, Any] = {"name": self.name, "score": self.score}
        if self.perhaps:
            found["perhaps"] = list(self.perhaps)
        if self.lines:
            found["lines"] = [{"wrong": wrong, "right": right} for wrong, right in self.lines]
        return found


class Obstacle(Enum):
    """Why a submission can answer nothing at all, whatever the case."""

    STUB = "the entry function is still to be written"
    ARITY = "the entry function takes another number of arguments"
    MODULE = "a module that it imports is not there"
    IMPORT = "an exception ends its import"
    NESTED = "the entry function stands in a class or another function"
    MISNAMED = "there is a name like the entry function's"
    NO_ENTRY = "there is no entry function, and nothing is read"


class Hurdle(Struct, frozen=True):
    """An obstacle in `line` of the file, 0 where it has none.

    `name` is the module, or the name that is like the entry's; `takes` says how many arguments it takes.
    """

    kind: Obstacle
    line: int = 0
    name: str = ""
    takes: str = ""


class Result(Struct, frozen=True):
    """The outcome of one submission on one problem.

    `score` sums the points of the accepted groups, `points` those of all groups that were run. The verdict
    is that of the first failing group; `groups` is empty where nothing could be run (CE, JE). `notes` are
    sentences for the person about what did not go as it should beside the verdict; they are not published.
    `levels` are those of the problem, the easier first; none where it has none, or nothing could be run.
    """

    problem: str
    submission: str
    mode: Mode
    verdict: Verdict
    groups: tuple[GroupResult, ...] = ()
    failure: Failure | None = None
    time: Timing = Timing()
    memory_bytes: int = 0
    isolation: str = ""
    counterexample: dict[str, Any] | None = None
    pitfall: Pitfall | None = None
    counterexample_given: Raw = None  # the answer to it, as the submission sent it; not published
    notes: tuple[str, ...] = ()
    levels: tuple[LevelResult, ...] = ()
    hurdle: Hurdle | None = None  # not published: `failure` is
    out_of: int = 0  # how many groups the problem has, where some were left out; not published

    def __repr__(self) -> str:
        """One line: who did what, and how it ended."""
        where = f", in {self.failure.group}" if self.failure and self.failure.group else ""
        named = f", {self.pitfall.name}" if self.pitfall else ""
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

    @property
    def score(self) -> int:
        """The points of the accepted groups."""
        return sum(group.score for group in self.groups)

    @property
    def points(self) -> int:
        """The points of all groups that were run: 100 unless some were left out."""
        return sum(group.points for group in self.groups)

    @property
    def exit_code(self) -> ExitCode:
        """What this result alone tells the shell."""
        if self.verdict is Verdict.AC:
            return ExitCode.ACCEPTED
        return ExitCode.FAULT if self.verdict is Verdict.JE else ExitCode.NOT_ACCEPTED

    def as_json(self) -> dict[str, Any]:
        """The published object; its keys and their order are fixed by the schema number."""
        levels = {"levels": [level.as_json() for level in self.levels]} if self.levels else {}
        return {
            "schema": SCHEMA,
            "problem": self.problem,
            "submission": self.submission,
            "mode": self.mode.value,
            "verdict": self.verdict.value,
            "score": self.score,
            **levels,
            "groups": [group.as_json() for group in self.groups],
            "failure": self.failure.as_json() if self.failure else None,
            "counterexample": self.counterexample,
            "pitfall": self.pitfall.as_json() if self.pitfall else None,
            "time": self.time.as_json(),
            "memory_bytes": self.memory_bytes,
            "isolation": self.isolation or None,
        }


def exit_code(results: list[Result]) -> ExitCode:
    """What several results together tell the shell: the judge's fault weighs most, then a rejection."""
    return max((result.exit_code for result in results), default=ExitCode.ACCEPTED)
