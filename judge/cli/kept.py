"""The history as commands use it: what is damaged is said once, and it never stands in a verdict's way."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import click

from judge.report.screen import note

if TYPE_CHECKING:
    from judge.practice.history import History


@contextmanager
def history_at(path: Path | None, *, reading: bool = False) -> Iterator[History]:
    """As `History.open`; afterwards a note says what was left out or set aside, each once a command."""
    from judge.practice.history import History

    with History.open(path, reading=reading) as history:
        try:
            yield history
        finally:
            context = click.get_current_context(silent=True)
            said: set[object] = set() if context is None else context.meta.setdefault(__name__, set())
            if found := len(history.left_out - said):
                what = "1 damaged row is" if found == 1 else f"{found} damaged rows are"
                note(f"{what} left out of the history")
            said |= history.left_out
            if history.set_aside is not None:
                from judge.report.words import shown_name  # only for the one who is told

                name = shown_name(str(history.set_aside))
                note(f"the history was damaged: it is kept as {name}, and a new one is begun")
