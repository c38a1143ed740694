"""The picture of a failing case, as `judge run` draws and saves it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from msgspec import Struct

from judge.cli.target import svg_target
from judge.data.model import ProblemData
from judge.errors import told
from judge.problem import Problem
from judge.problem.model import case_of
from judge.problem.topic import Shown
from judge.report.layout import Line
from judge.report.screen import Screen, note
from judge.run.result import Result

if TYPE_CHECKING:
    from judge.drawing import Picture


class Drawing(Struct, frozen=True):
    """A result and what its picture is drawn from; nothing is computed until it is asked for."""

    problem: Problem
    data: ProblemData
    result: Result

    def picture(self) -> Picture | None:
        """The smallest case found that fails, or else the first one; None where there is nothing to draw."""
        failure = self.result.failure
        group = self.problem.group(failure.group) if failure and failure.group else None
        if failure is None or group is None:
            return None
        found = self.result.counterexample or {}
        heading = f"{group.name}, case {failure.case}"
        values, wanted, got, given = failure.input, failure.expected, failure.got, failure.given
        if found.get("input"):
            heading, values = "counterexample", found["input"]
            wanted, got = found.get("expected"), found.get("got")
            given = self.result.counterexample_given
        if not values:
            return None
        draw = self.data.module.topic.picture
        if draw is None:
            return None
        exact, _ = self.data.exact(case_of(values), group)
        return draw(Shown(self.problem, values, exact, wanted, got, given, heading))

    def lines(self, screen: Screen, *, beside: int) -> list[Line]:
        """The drawing for a terminal, low enough that so many other lines are seen with it.

        Nothing where it cannot be shown.
        """
        if self.result.failure is None:
            return []
        from judge.report.picture import has_room, picture_lines
        from judge.report.terminal import height

        try:
            picture = self.picture() if has_room(screen) else None
        except Exception as fault:  # the verdict is known, and worth more
            note(f"the failing case is not drawn: {told(fault)}")
            return []
        return list(picture_lines(picture, height(screen) - beside)) if picture else []

    def save(self, path: Path | None) -> None:
        """Write the SVG, if one was asked for. Raises UsageError where that cannot be done."""
        if path is None:
            return
        from judge.drawing.svg import to_svg

        picture = self.picture()
        if picture is None:
            text = f"nothing to draw, {path} is not written: no case failed that can be drawn"
            note(text)
            return
        svg_target(path).write(to_svg(picture).encode())
