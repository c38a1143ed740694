"""What the machine gives, for the screen: the isolation levels, and the level in use last."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from judge.report.layout import Cell, Column, Line, Span, Style, Table, hanging, line
from judge.report.values import counted

if TYPE_CHECKING:
    from judge.languages.find import Found
    from judge.sandbox.attacking import Attacked
    from judge.sandbox.probe import Level

_LANGUAGES = 12
_LABELS = 10  # the column where what follows a label begins


def doctor_lines(
    facts: Mapping[str, str], levels: Sequence[Level], languages: Sequence[Found], width: int | None
) -> Iterator[Line]:
    """Facts, each level with what it is or what it lacks, the languages beside Python, the level in use."""
    for label, fact in facts.items():
        yield from hanging(Span(label, Style.FAINT), Span(fact), width, indent=0, column=_LABELS)
    yield line()
    for level in levels:
        style = Style.GOOD if level.available else Style.WARNING
        yield from hanging(Span(level.name, style), Span(level.meaning), width, indent=0, column=_LABELS)
        for label, text in (*_looked(level), ("missing", level.why_not), ("remedy", level.remedy)):
            if text:
                yield from hanging(Span(label, Style.FAINT), Span(text), width, indent=_LABELS, column=20)
    yield line()
    best = next((level for level in levels if level.available), None)
    for each in languages:
        style = Style.GOOD if each.version else Style.FAINT
        text = each.version or f"missing {each.missing}: {each.remedy}"
        if each.works and best:
            text += f", works at {best.name}"
        style = Style.WARNING if each.works is False else style
        yield from hanging(Span(each.name, style), Span(text), width, indent=0, column=_LANGUAGES)
        if each.works is False:
            for label, words in (("fails", each.why_not), ("remedy", each.remedy)):
                yield from hanging(Span(label, Style.FAINT), Span(words), width, indent=_LANGUAGES, column=22)
    yield line()
    used = Span(f"isolation is {best.name}", Style.STRONG) if best else Span("nothing can be run", Style.BAD)
    yield line(used)


def attack_lines(level: str, attacks: Sequence[Attacked], width: int | None) -> Iterator[Line]:
    """Each attack, whether it was held, and how; and how many were."""
    columns = (Column("attack"), Column("a submission tries to", flexible=True), Column("result"))
    rows: list[list[Cell]] = [
        [
            Span(each.attack.name, Style.STRONG),
            each.attack.tries,
            Span("held", Style.GOOD) if each.held else Span("NOT HELD", Style.BAD),
        ]
        for each in attacks
    ]
    yield from Table(columns, rows, indent=0).lines(width)
    yield line()
    for each in attacks:
        if not each.held:
            yield from hanging(Span(each.attack.name, Style.BAD), Span(each.how), width, indent=0, column=20)
    held = sum(each.held for each in attacks)
    style = Style.GOOD if held == len(attacks) else Style.BAD
    text = f"{held} of {counted(len(attacks), 'attack')} held at isolation {level}"
    yield line(Span(text, style))


def _looked(level: Level) -> Iterator[tuple[str, str]]:
    """What the submission that tried the level could read of what none may see."""
    if level.visible == "":
        yield "tried", "a submission cannot read the judge, its problems or its solutions"
    elif level.visible:
        yield "tried", f"a submission can read {level.visible}"
