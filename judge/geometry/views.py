"""The view of each kind of case: how it is drawn, and how its answer is."""

from __future__ import annotations

from collections.abc import Mapping
from inspect import CO_VARARGS
from typing import Any

from judge.drawing.shapes import Role
from judge.geometry import figures, marks, sequences
from judge.geometry.view import Plain, View, decimal


def view_of(kind: str, values: Mapping[str, Any], exact: Plain, given: Plain) -> View | None:
    """What is drawn of a case; None where its arguments are not of that kind."""
    build, mark, *part = VIEWS[kind]
    most = build.__code__.co_argcount - len(build.__defaults__ or ())  # arguments of the case
    if len(values) != most and not build.__code__.co_flags & CO_VARARGS:
        return None
    parts = {"part": part[0]} if part else {}
    view: View | None = build(
        *_read(list(values.values())), names=list(values), answers=(exact, given), **parts
    )
    if view is not None:
        for answer, role in ((exact, Role.WANTED), (given, Role.GOT)):
            mark(view, answer, role)
    return view


def _read(value: Any) -> Any:
    if isinstance(value, list | tuple):
        return [_read(each) for each in value]
    return value if isinstance(value, str) else decimal(value)


VIEWS: Mapping[str, tuple[Any, ...]] = {
    "line": (figures.circle_and_line, marks.common),
    "points": (figures.circle_and_line, marks.listed),
    "segment": (figures.circle_and_line, marks.listed, "segment"),
    "count in a segment": (figures.circle_and_line, marks.nothing, "segment"),
    "chord": (figures.circle_and_line, marks.chord),
    "seven": (figures.seven_numbers, marks.nothing),
    "ray": (figures.circle_and_ray, marks.on_ray),
    "normal": (figures.circle_and_ray, marks.normal),
    "reflection": (figures.circle_and_ray, marks.bounce),
    "sphere": (figures.sphere_and_ray, marks.spatial),
    "point": (figures.circle_and_point, marks.nothing),
    "tangents": (figures.circle_and_point, marks.touching),
    "foot": (figures.line_and_foot, marks.nearest_point),
    "foot on an axis": (figures.line_and_foot, marks.listed, "segment"),
    "normal form": (figures.line_and_origin, marks.normal_form),
    "side": (figures.line_and_point, marks.nothing),
    "two points": (figures.two_points, marks.nothing),
    "diameter": (figures.diameter, marks.nothing),
    "pair": (figures.two_circles, marks.listed),
    "common tangents": (figures.two_circles, marks.across),
    "hits": (figures.many_circles, marks.tagged),
    "spans": (figures.many_circles, marks.spans),
    "light": (figures.light, marks.nothing),
    "polygon": (figures.polygon, marks.listed),
    "balls": (figures.two_discs, marks.nothing),
    "wall": (figures.disc_and_wall, marks.nothing),
    "frames": (sequences.first_wrong_frame, marks.nothing),
    "rows": (sequences.first_wrong_row, marks.nothing),
    "many": (sequences.first_wrong_ray, marks.nothing),
}
