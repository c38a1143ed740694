"""The history as commands open it: what is damaged in it is said once, at the end."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from judge.kata.history import History
from judge.report.screen import note


@contextmanager
def history_at(path: Path | None, *, reading: bool = False) -> Iterator[History]:
    """As `History.open`; afterwards a note says what was left out, set aside, or kept beside it."""
    with History.open(path, reading=reading) as history:
        try:
            yield history
        finally:
            tell(history)


def tell(history: History) -> None:
    """Say what was left out, set aside, or kept beside the history; each once a command."""
    context = click.get_current_context(silent=True)
    said: set[object] = set() if context is None else context.meta.setdefault(__name__, set())
    found = history.left_out - said
    said |= history.left_out
    if found:
        what = "1 damaged row is" if len(found) == 1 else f"{len(found)} damaged rows are"
        note(f"{what} left out of the history")
    if history.set_aside is not None:
        from judge.report.names import shown_name  # only for the one who is told

        name = shown_name(str(history.set_aside))
        note(f"the history was damaged: it is kept as {name}, and a new one is begun")
    if history.waiting:
        note(LOCKED)


LOCKED = "another program locks the history: what is new waits beside it, and goes in when it is next used"
