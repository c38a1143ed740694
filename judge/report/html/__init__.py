"""HTML pages: one file each, which loads nothing and runs nothing.

    pages.py      a failing case, a result in a notebook; a class, and a page for each student
    templates/    a template a page or file, their common parts, and the one style sheet

Templates escape whatever they are given; only drawings, which `judge.drawing` has escaped, go in as they are.
The policy of a page allows its style sheet, by its hash, and nothing else.
"""

from __future__ import annotations

import base64
import hashlib
import re
from collections.abc import Iterable
from datetime import datetime
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import Markup, escape

from judge import __version__
from judge.drawing import Picture
from judge.drawing.shapes import Panel
from judge.drawing.svg import panel_svg, style
from judge.problem import Verdict
from judge.report.tell import level_share
from judge.report.words import counted, printable

if TYPE_CHECKING:
    from jinja2 import Environment

    from judge.report.html.pages import ShownCase

_TEMPLATES = Path(__file__).parent / "templates"
_TIME = re.compile(rb"<time.*?</time>")


def page(
    template: str,
    mark: str,
    cases: Iterable[ShownCase | None],
    verdicts: Iterable[Verdict],
    rule: str = "",
    **values: Any,
) -> bytes:
    """The file that a template makes of these values; the same values always give the same bytes.

    `mark` says what kind of page it is, for `is_page`. Its foot explains the `verdicts`, and the drawings
    where one of the `cases` has any. `rule` is a rule of CSS for this page alone.
    """
    sheet = (_TEMPLATES / "page.css").read_text(encoding="utf-8")
    sheet += style("figure", "screen and (prefers-color-scheme:dark)") + rule
    digest = base64.b64encode(hashlib.sha256(sheet.encode()).digest()).decode()
    found = {*verdicts}
    given = {
        "mark": mark,
        "version": __version__,
        "style": Markup(sheet),
        "policy": f"default-src 'none'; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'",
        "drawn": any(case and case.picture for case in cases),
        "verdicts": [verdict for verdict in Verdict if verdict in found],
    }
    return rendered(template, **values | given)


def rendered(template: str, **values: Any) -> bytes:
    """The text that a template makes of these values, in UTF-8."""
    return _environment().get_template(template).render(values).encode()


def is_page(head: bytes, mark: str) -> bool:
    """Whether a file that begins like this is a page of that kind, which may be written over."""
    return b"<!doctype html>" in head[:40] and f'content="{mark},'.encode() in head


def is_same(old: bytes, new: bytes) -> bool:
    """Whether two pages say the same, whenever they were made."""
    return _TIME.sub(b"", old) == _TIME.sub(b"", new)


@cache
def _environment() -> Environment:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        finalize=lambda value: printable(value) if type(value) is str else value,
    )
    told = {"counted": counted, "date": _date, "lines": _lines, "share": level_share}
    environment.filters |= {**told, "panels": _panels}
    return environment


def _panels(picture: Picture, anchor: str) -> list[tuple[Markup, Panel]]:
    """The panels of a picture, each as an SVG element and as it is."""
    named = zip(("whole", "lens"), picture.panels, strict=False)
    return [(Markup(panel_svg(each, f"{anchor}-{name}", picture.description)), each) for name, each in named]


def _date(when: datetime) -> Markup:
    return Markup(f'<time datetime="{when.date().isoformat()}">{when.day} {when:%b %Y}</time>')


def _lines(text: str) -> Markup:
    """A program's lines, escaped; whatever does not print is written out."""
    return escape("\n".join(printable(each.expandtabs(4)) for each in text.splitlines()))
