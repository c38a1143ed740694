"""One result by itself, for a person."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from judge.cli.picture import Drawing


def show_result(drawing: Drawing, source: bytes = b"") -> None:
    """Show it as `judge run` does."""
    from judge.report.judged import Judged, judged
    from judge.report.screen import out, show

    screen = out()
    shown = judged(Judged(drawing.result, source, drawing.problem, drawing), screen)
    if shown is not None:
        show(shown, screen)
