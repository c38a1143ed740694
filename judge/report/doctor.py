"""What the machine gives, for the screen: the isolation levels, and the level in use last."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from judge.report.layout import Line, Span, Style, hanging, line

if TYPE_CHECKING:
    from judge.sandbox.probe import Level

_LABELS = 10  # the column where what follows a label begins


def doctor_lines(facts: Mapping[str, str], levels: Sequence[Level], width: int | None) -> Iterator[Line]:
    """Facts, then each level with what it is or what it lacks, then the one that is used."""
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
    used = Span(f"isolation is {best.name}", Style.STRONG) if best else Span("nothing can be run", Style.BAD)
    yield line(used)


def _looked(level: Level) -> Iterator[tuple[str, str]]:
    """What the submission that tried the level could read of what none may see."""
    if level.visible == "":
        yield "tried", "a submission cannot read the judge, its problems or its solutions"
    elif level.visible:
        yield "tried", f"a submission can read {level.visible}"
