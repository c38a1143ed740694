"""The history as commands open it: what is damaged in it is said once, in the end."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from judge.kata.history import History
from judge.report.screen import note

_NAMED = 5


@contextmanager
def history_at(path: Path | None, *, reading: bool = False) -> Iterator[History]:
    """As `History.open`; afterwards a note says what was left out, and what is kept beside it."""
    with History.open(path, reading=reading) as history:
        try:
            yield history
        finally:
            tell(history)


def tell(history: History) -> None:
    """Say what was left out, and what is kept beside the history; each once a command."""
    context = click.get_current_context(silent=True)
    said: list[str] = [] if context is None else context.meta.setdefault(__name__, [])
    found = [text for text in history.left_out if text not in said]
    said += found
    if found:
        more = f" and {len(found) - _NAMED} more" if len(found) > _NAMED else ""
        named = f"{', '.join(found[:_NAMED])}{more}"
        what = "is damaged and left out" if len(found) == 1 else "are damaged and left out"
        note(f"{named} in the history {what}; 'judge history --repair' keeps the rest")
    if history.waiting:
        note(LOCKED)


LOCKED = "another program locks the history: what is new waits beside it, and goes in when it is next used"
