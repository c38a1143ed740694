"""A class as one HTML page: the table, the cohort, of every mistake one case drawn, equal files, machines.

Like the report of one person it loads nothing and runs nothing, and whatever a student, a file or a program
is called is text.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from pathlib import PurePath

from msgspec import Struct

from judge import __version__
from judge.problem import Verdict
from judge.report.cohort.parts import EQUAL_CAUTION, Cohort, Counted, Example, MistakeBar, ProblemView
from judge.report.page.known import KnownProblem
from judge.report.page.parts import Drawing, Explained, Tile
from judge.report.page.render import filled
from judge.report.page.told import Artist, kind_title, told_case

MARK = "judge class page"  # what tells a file that is such a page
_MANY = 8  # problems, from which on the printed table has verdicts and points alone
_INLINE = 12  # names that are in sight; longer lists are folded away


class BarLine(Struct, frozen=True):
    """One bar: `share` in percent of the width, `case` the place of its case in the page, if there is one."""

    label: str
    count: int
    of: int
    share: str
    named: bool
    who: tuple[str, ...] = ()
    case: str = ""


class CaseCard(Struct, frozen=True):
    """One mistake, drawn; the rest is as of `judge.report.page.parts.FailingCase`."""

    anchor: str
    title: str
    verdict: Verdict
    count: int
    file: str
    kind: str
    facts: tuple[tuple[str, str, str], ...]
    drawings: tuple[Drawing, ...]
    marks: tuple[str, ...]
    explained: tuple[Explained, ...]


class ClassPart(Struct, frozen=True):
    """One problem of the class."""

    anchor: str
    id: str
    title: str
    handed_in: int
    accepted: int
    mistakes: tuple[BarLine, ...]
    groups: tuple[BarLine, ...]
    cards: tuple[CaseCard, ...]


class StudentLine(Struct, frozen=True):
    """A row of the table: what counts of a student on each problem, None where nothing was handed in."""

    id: str
    name: str
    group: str
    known: bool
    cells: tuple[Counted | None, ...]
    total: int


class ClassPage(Struct, frozen=True):
    """The whole page."""

    title: str
    generated: datetime
    version: str
    tiles: tuple[Tile, ...]
    parts: tuple[ClassPart, ...]
    lines: tuple[StudentLine, ...]
    cohort: Cohort
    names: Mapping[str, str]
    verdicts: tuple[Verdict, ...]
    caution: str = EQUAL_CAUTION
    inline: int = _INLINE

    @property
    def grouped(self) -> bool:
        """Whether anybody is in a group."""
        return any(line.group for line in self.lines)

    @property
    def many(self) -> bool:
        """Whether there are more problems than a printed table has room for in full."""
        return len(self.parts) > _MANY

    @property
    def drawn(self) -> bool:
        """Whether there is a picture on it."""
        return any(card.drawings for part in self.parts for card in part.cards)

    @property
    def handed(self) -> tuple[tuple[str, str, Counted], ...]:
        """What counts, each with its student and problem, in the order of the table."""
        marks = self.cohort.marks
        order = ((line.id, part.id) for line in self.lines for part in self.parts)
        return tuple((*pair, marks[pair]) for pair in order if pair in marks)


def render_class(
    cohort: Cohort,
    examples: Sequence[Example],
    known: Mapping[str, KnownProblem],
    *,
    title: str,
    generated: datetime,
) -> bytes:
    """The file. The same values always give the same bytes.

    Args:
        cohort: the class.
        examples: at most one for each bar of each problem.
        known: the problems that are still there, by id; of others no case is drawn.
        title: what the class is called: its folder, most likely.
        generated: when the page is made, in the zone that it is told in.
    """
    page = ClassPage(
        title=title,
        generated=generated,
        version=__version__,
        tiles=tuple(_tiles(cohort)),
        parts=tuple(
            _part(f"problem-{place}", view, cohort, examples, known.get(view.problem))
            for place, view in enumerate(cohort.views, 1)
        ),
        lines=tuple(_lines(cohort)),
        cohort=cohort,
        names=_names(cohort),
        verdicts=tuple(
            each for each in Verdict if any(mark.verdict is each for mark in cohort.marks.values())
        ),
    )
    return filled("class.html.j2", page=page, mark=MARK)


def is_class_page(head: bytes) -> bool:
    """Whether a file that begins like this is such a page."""
    return b"<!doctype html>" in head[:40] and f'content="{MARK}'.encode() in head


def _names(cohort: Cohort) -> dict[str, str]:
    """What each student is called: the name of the list, with the id where two have one name."""
    often = Counter(each.name for each in cohort.people)
    shown = {}
    for each in cohort.people:
        plain = each.name if often[each.name] == 1 else f"{each.name} ({each.id})"
        shown[each.id] = plain if each.name else each.id
    return shown


def _tiles(cohort: Cohort) -> Iterator[Tile]:
    marks = cohort.marks.values()
    yield Tile(str(len(cohort.people)), "student" if len(cohort.people) == 1 else "students")
    yield Tile(f"{cohort.handins:,}", f"hand-{'in' if cohort.handins == 1 else 'ins'} judged")
    yield Tile(f"{sum(mark.accepted for mark in marks)} of {len(marks)}", "solved, by student and problem")
    made = {(view.problem, bar.label) for view in cohort.views for bar in view.mistakes if bar.named}
    yield Tile(str(len(made)), "mistake named" if len(made) == 1 else "mistakes named")
    if cohort.silent:
        yield Tile(str(len(cohort.silent)), "handed in nothing")


def _lines(cohort: Cohort) -> Iterator[StudentLine]:
    for each in cohort.people:
        cells = tuple(cohort.marks.get((each.id, problem)) for problem in cohort.problems)
        yield StudentLine(each.id, each.name, each.group, each.known, cells, cohort.total(each.id))


def _part(
    anchor: str,
    view: ProblemView,
    cohort: Cohort,
    examples: Sequence[Example],
    known: KnownProblem | None,
) -> ClassPart:
    own = {each.label: each for each in examples if each.problem == view.problem}
    artist = Artist(known.problem if known else None)
    cards = {
        bar.label: _card(f"{anchor}-case-{place}", bar, own[bar.label], artist, known)
        for place, bar in enumerate(view.mistakes, 1)
        if bar.label in own
    }
    names = _names(cohort)
    mistakes = []
    for bar in view.mistakes:
        who = tuple(names.get(each, each) for each in bar.students)
        case = cards[bar.label].anchor if bar.label in cards else ""
        mistakes.append(_bar(_label(bar), bar.count, view.handed_in, named=bar.named, who=who, case=case))
    return ClassPart(
        anchor=anchor,
        id=view.problem,
        title=known.problem.title if known else view.problem,
        handed_in=view.handed_in,
        accepted=view.accepted,
        mistakes=tuple(mistakes),
        groups=tuple(_bar(each.name, each.failed, each.run) for each in view.groups),
        cards=tuple(cards.values()),
    )


def _bar(
    label: str, count: int, of: int, *, named: bool = True, who: tuple[str, ...] = (), case: str = ""
) -> BarLine:
    return BarLine(label, count, of, f"{100 * count / max(1, of):.2f}%", named, who, case)


def _label(bar: MistakeBar) -> str:
    return bar.label if bar.named else f"{bar.meaning}, not named" if bar.label == "WA" else bar.meaning


def _card(
    anchor: str, bar: MistakeBar, example: Example, artist: Artist, known: KnownProblem | None
) -> CaseCard:
    result = example.result
    told = told_case(result, example.file, artist, anchor)
    made = zip(result.pitfall.names, result.pitfall.advice, strict=True) if result.pitfall else ()
    advice = {**(known.advice if known else {}), **{name: text for name, text in made if text}}
    names = bar.label.split(" + ") if bar.named else []
    return CaseCard(
        anchor=anchor,
        title=bar.label if bar.named else kind_title(result.verdict, told.group),
        verdict=result.verdict,
        count=bar.count,
        file=PurePath(example.file).as_posix(),
        kind=told.kind,
        facts=told.facts,
        drawings=told.drawings,
        marks=told.marks,
        explained=tuple(Explained(name, advice[name]) for name in names if name in advice),
    )
