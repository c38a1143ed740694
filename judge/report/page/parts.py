"""What a page is made of: values in the words and places that the templates only have to put down."""

from __future__ import annotations

from datetime import datetime
from itertools import pairwise

from msgspec import Struct

from judge.problem import Verdict


class Tile(Struct, frozen=True):
    """A figure at the head of the page: `12 of 22`, `skills`."""

    value: str
    label: str


class SkillLine(Struct, frozen=True):
    """One line of the checklist of skills.

    `state` is "shown", "lost" (the latest run fails what an earlier one passed) or "open"; `share`
    says of a part how much it is; `since` is when it was first shown whole.
    """

    name: str
    about: str
    state: str
    share: str = ""
    since: datetime | None = None
    attempts: int = 0
    mistakes: tuple[str, ...] = ()

    @property
    def ticked(self) -> bool:
        """Whether all that the skill asks for is passed."""
        return self.state == "shown"


class ReadyLine(Struct, frozen=True):
    """A question of the checklist: `by` says what ticks it, or else what would."""

    id: str
    ask: str
    state: str  # as of SkillLine
    by: str
    since: datetime | None


class ReadyPart(Struct, frozen=True):
    """A section of the checklist."""

    title: str
    lines: tuple[ReadyLine, ...]

    @property
    def ticked(self) -> int:
        """How many of its questions are ticked."""
        return sum(line.state == "shown" for line in self.lines)


class RunLine(Struct, frozen=True):
    """One run: `case` is the anchor of the failing case shown for its mistake, empty where none is."""

    number: int
    when: datetime
    verdict: Verdict
    score: str
    ratio: str
    mistake: str
    case: str
    submission: str


class Dot(Struct, frozen=True):
    """A run in the plot: `x` in percent of its width, the rest in pixels from the top."""

    x: str
    y: float
    top: float
    bottom: float
    kind: str  # "ac", "tle" or "doubt" (a ratio that deserves no belief)
    label: str  # below the axis; empty where there is no room for one
    number: int


class GridLine(Struct, frozen=True):
    """A horizontal line of the plot and its label."""

    y: float
    label: str


class Plot(Struct, frozen=True):
    """The time ratio over the attempts, oldest left, on a logarithmic scale; `links` join the dots."""

    name: str  # begins the ids
    height: float
    dots: tuple[Dot, ...]
    links: tuple[tuple[Dot, Dot], ...]
    levels: tuple[GridLine, ...]
    limit: GridLine | None
    description: str
    left_out: int  # earlier runs that are not shown
    held: str = ""  # which runs were held to the reference of another language, and why


class GrowthDot(Struct, frozen=True):
    """What a case of some size took: `x` in percent, `y` in pixels; `open` where it is a bound."""

    x: str
    y: float
    open: bool
    title: str


class GrowthLine(Struct, frozen=True):
    """One program's dots, by size, with what it is called and the law they follow; `links` join them.

    The `upper` line has its label above its end, the other one below its beginning, off both lines.
    """

    kind: str  # "ref" or "own"
    label: str
    dots: tuple[GrowthDot, ...]
    upper: bool

    @property
    def links(self) -> tuple[tuple[GrowthDot, GrowthDot], ...]:
        """Each dot and the next one."""
        return tuple(pairwise(self.dots))


class GrowthPlot(Struct, frozen=True):
    """CPU time of a case against n, both on logarithmic scales, of a submission and the reference."""

    name: str  # begins the ids
    height: float
    run: int
    lines: tuple[GrowthLine, ...]
    levels: tuple[GridLine, ...]
    columns: tuple[tuple[str, str], ...]
    text: str


class Drawing(Struct, frozen=True):
    """One panel of a picture, as an SVG element, with its heading and its note."""

    svg: str
    title: str
    note: str


class Explained(Struct, frozen=True):
    """A mistake by its name, with what is wrong and what to do instead."""

    name: str
    advice: str


class FailingCase(Struct, frozen=True):
    """The latest failing case of one kind: a mistake, or a verdict in a group where none is named.

    `overcome` is when the problem was solved after it. `kind` says what case it is.
    """

    anchor: str
    title: str
    number: int
    when: datetime
    verdict: Verdict
    times: int  # runs that failed in this way
    overcome: datetime | None
    kind: str
    facts: tuple[tuple[str, str, str], ...]  # label, text, style: "wanted", "got", "code" or ""
    drawings: tuple[Drawing, ...]
    marks: tuple[str, ...]  # "wanted" and "got", where the drawings show such points
    explained: tuple[Explained, ...]


class GroupMark(Struct, frozen=True):
    """A test group as the latest run that had it left it: "passed", "failed", or "open" where none had.

    `level` is empty where the problem has none.
    """

    name: str
    about: str
    state: str
    detail: str
    level: str = ""


class LevelMark(Struct, frozen=True):
    """A level of a problem: the most of its `groups` that one run passed, and when one first passed all."""

    name: str
    groups: int
    best: int
    since: datetime | None


class KillCell(Struct, frozen=True):
    """How much of a group rejects a program: `shade` from 0 (nothing) to 5, `own` where it is aimed at it."""

    group: str
    text: str
    shade: int
    own: bool


class KillLine(Struct, frozen=True):
    """A known-wrong program; `made` is how often a run was explained by its mistake."""

    name: str
    made: int
    cells: tuple[KillCell, ...]


class KillTable(Struct, frozen=True):
    """Which group catches which mistake, and how few cases would catch all."""

    groups: tuple[str, ...]
    lines: tuple[KillLine, ...]


class ProblemPart(Struct, frozen=True):
    """One problem with runs. `earlier` are the runs after the first page of them, `more` are not shown."""

    anchor: str
    id: str
    title: str
    summary: str
    tier: str
    solved: datetime | None
    best: str
    attempts: int
    levels: tuple[LevelMark, ...]
    groups: tuple[GroupMark, ...]
    runs: tuple[RunLine, ...]
    earlier: tuple[RunLine, ...]
    more: int
    plot: Plot | None
    growth: GrowthPlot | None
    cases: tuple[FailingCase, ...]
    cases_left_out: int
    kills: KillTable | None
    source: str
    source_name: str
    source_run: int

    @property
    def passed_level(self) -> str:
        """`interview passed`, for a level that was; empty where none was."""
        return next((f"{level.name} passed" for level in self.levels if level.since), "")


class OverviewLine(Struct, frozen=True):
    """A problem in the table of all; `part` is None where it was never tried."""

    id: str
    title: str
    tier: str
    part: ProblemPart | None
    ratio: str
    last: datetime | None


class Page(Struct, frozen=True):
    """The whole report."""

    title: str
    person: str
    generated: datetime
    version: str
    first: datetime
    last: datetime
    tiles: tuple[Tile, ...]
    overview: tuple[OverviewLine, ...]
    untried: tuple[tuple[str, tuple[str, ...]], ...]  # the problems of each tier that have no run
    skills: tuple[SkillLine, ...]
    ready: tuple[ReadyPart, ...]  # the first one is what to be ready for
    problems: tuple[ProblemPart, ...]
    verdicts: tuple[Verdict, ...]  # those that occur, to be explained

    @property
    def has_levels(self) -> bool:
        """Whether a problem on it has levels."""
        return any(part.levels for part in self.problems)

    @property
    def drawn(self) -> bool:
        """Whether there is a picture on it."""
        return any(case.drawings for part in self.problems for case in part.cases)
