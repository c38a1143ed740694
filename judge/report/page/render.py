"""From a page to the bytes of one HTML file.

The templates escape whatever they are given; only the drawings, which `judge.drawing` has escaped,
go in as they are. The page's policy allows its one style sheet, by its hash, and nothing else.
"""

from __future__ import annotations

import base64
import hashlib
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from judge.drawing.svg import style
from judge.report.layout import printable
from judge.report.page.parts import Page

if TYPE_CHECKING:
    from jinja2 import Environment

MARK = "circle-line-judge report"  # what tells a file that is a report of ours

_TEMPLATES = Path(__file__).parent / "templates"
_MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")


def render(page: Page) -> bytes:
    """The whole file. The same page always gives the same bytes."""
    return filled("page.html.j2", page=page, mark=MARK)


def filled(template: str, **values: Any) -> bytes:
    """The file that one of the templates makes of these values, with the style sheet and its policy."""
    from markupsafe import Markup

    dark = "screen and (prefers-color-scheme:dark)"
    sheet = (_TEMPLATES / "page.css").read_text(encoding="utf-8") + style(".drawing", dark)
    digest = base64.b64encode(hashlib.sha256(sheet.encode()).digest()).decode()
    policy = f"default-src 'none'; style-src 'sha256-{digest}'; base-uri 'none'; form-action 'none'"
    return _environment().get_template(template).render(style=Markup(sheet), policy=policy, **values).encode()


def is_report(head: bytes) -> bool:
    """Whether a file that begins like this is a report of ours."""
    return b"<!doctype html>" in head[:40] and f'content="{MARK}'.encode() in head


def _environment() -> Environment:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    from markupsafe import Markup

    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        finalize=_shown,
    )
    environment.filters |= {
        "day": day,
        "clock": lambda when: f"{when:%H:%M}",
        "machine": lambda when: when.isoformat(timespec="seconds"),
        "drawing": Markup,
        "listing": _listing,
    }
    return environment


def day(when: datetime) -> str:
    """`3 Mar`, in no language but the page's."""
    return f"{when.day} {_MONTHS[when.month - 1]}"


def _shown(value: Any) -> Any:
    """Text with whatever does not print written out; markup of ours as it is."""
    return printable(value) if type(value) is str else value


def _listing(text: str) -> Any:
    """A program's lines, tabs and all, escaped; whatever else does not print is written out."""
    from markupsafe import escape

    rows = (printable(row.replace("\t", "    ")) for row in text.splitlines())
    return escape("\n".join(rows))
