"""The picture of a failing case, as `judge run` draws and saves it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cli.target import svg_target
from judge.data.load import ProblemData
from judge.errors import told
from judge.problem import Problem
from judge.problem.declare import Shown
from judge.problem.model import case_of
from judge.report.screen import Screen, note
from judge.run.result import Result

if TYPE_CHECKING:
    from rich.text import Text

    from judge.drawing import Picture
    from judge.drawing.chart import Chart


class Drawing(Struct, frozen=True):
    """A result and what its picture is drawn from; nothing is computed until it is asked for.

    Where no small case failed and the time has grown with n, how it has is drawn instead.
    """

    problem: Problem
    data: ProblemData
    result: Result
    source: bytes = b""

    @property
    def _has_any(self) -> bool:
        """Whether there may be something to draw: a case that failed, or how the time grows."""
        return self.result.failure is not None or self.result.time.growth is not None

    def rows(self, screen: Screen) -> Callable[[int], Sequence[Text]] | None:
        """What draws it in so many rows; None where there is nothing to draw, or no room."""
        if not self._has_any or self.result.hurdle is not None:
            return None
        from judge.report.picture import has_room, picture_rows

        try:
            picture = self.picture() if has_room(screen) else None
        except Exception as fault:  # the verdict is known, and worth more
            note(f"the failing case is not drawn: {told(fault)}")
            return None
        return (lambda rows: picture_rows(picture, rows)) if picture else None

    def picture(self) -> Picture | Chart | None:
        """The smallest case found that fails, or else the first one; None where there is nothing to draw."""
        failure = self.result.failure
        group = self.problem.group(failure.group) if failure and failure.group else None
        growth = self.result.time.growth
        if growth is not None and (failure is None or failure.input is None):
            from judge.report.picture import growth_chart

            return growth_chart(growth)
        if failure is None or group is None:
            return None
        shown, heading = failure, f"{group.name}, case {failure.case}"
        if self.result.counterexample is not None and self.result.counterexample.input:
            shown, heading = self.result.counterexample, "counterexample"
        draw = self.data.module.hooks.picture
        if not shown.input or draw is None:
            return None
        exact, _ = self.data.exact(case_of(shown.input), group)
        return draw(Shown(self.problem, shown.input, exact, shown.expected, shown.got, shown.given, heading))

    def save(self, path: Path | None) -> None:
        """Write the SVG, if one was asked for. Raises UsageError where that cannot be done."""
        if path is None:
            return
        from judge.drawing import Picture
        from judge.drawing.chart import chart_svg
        from judge.drawing.svg import to_svg

        picture = self.picture()
        if picture is None:
            text = f"nothing to draw, {path} is not written: no case failed that can be drawn"
            note(text)
            return
        drawn = to_svg(picture) if isinstance(picture, Picture) else chart_svg(picture, alone=True)
        svg_target(path).write(drawn.encode())
