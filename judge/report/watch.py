"""What is seen of a kata while it is watched, as text for a screen: the verdict last, and the keys below."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from judge.report.glance import glance_lines
from judge.report.layout import Line, Span, Style, hanging, line
from judge.report.screen import Screen
from judge.run.result import Result

_KEYS = {
    "n": "next",
    "h": "hint",
    "l": "list",
    "w": "why",
    "p": "picture",
    "r": "run again",
    "q": "quit",
}


def report_lines(
    result: Result, screen: Screen, rows: int, drawing: Iterable[Line] = (), hurdle: Sequence[Line] = ()
) -> list[Line]:
    """The result in so many rows, with a drawing of its failing case."""
    end = _onward(result, screen)
    return glance_lines(result, screen.width, rows, hurdle=hurdle, drawing=drawing, end=end)


def note_text(text: str, screen: Screen, style: Style = Style.WARNING) -> str:
    """A sentence of the judge's own."""
    return screen.text(hanging(Span(""), Span(text, style), screen.width, indent=0, column=0))


def prompt_text(screen: Screen) -> str:
    """The keys on one line, without its end: what they do where there is room for it."""
    width = screen.width or 80
    full = [(Span(key, Style.STRONG), f" {about}") for key, about in _KEYS.items()]
    short = [(Span(key, Style.STRONG), f"){about.split()[0][1:]}") for key, about in _KEYS.items()]
    bare = [(Span(key, Style.STRONG), "") for key in _KEYS]
    for keys, gap in ((full, "   "), (full, "  "), (short, " "), (bare, " ")):
        spans = [part for key, about in keys for part in (gap, key, about)][1:]
        if sum(len(part if isinstance(part, str) else part.text) for part in spans) < width:
            break
    return screen.text([line(*spans)]).rstrip("\n")


def _onward(result: Result, screen: Screen) -> list[Line]:
    if not result.solved:
        return []
    text = f"n goes on to the next kata, judge solution {result.problem} explains a model solution"
    return hanging(Span("then", Style.FAINT), Span(text), screen.width, indent=2, column=8)
