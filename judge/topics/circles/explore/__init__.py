"""The page of `judge explore`: a circle and a line, segment or ray to drag, decided exactly in the browser.

page.html, page.css, drawing.js and page.js are the page; exact.js is its arithmetic, in BigInt, which a test
holds against line.py and bands.py. One file comes out, which loads nothing.
"""

from __future__ import annotations

import hashlib
import json
import re
from base64 import b64encode
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import Any

from judge.problem import Problem
from judge.topics.circles.part import Part

_FOLDER = Path(__file__).parent
_KINDS = {Part.LINE: "line", Part.CHORD: "line", Part.SEGMENT: "segment", Part.RAY: "ray"}
_PROBLEMS = {"line": "count", "segment": "segment", "ray": "ray-nearest"}  # for `judge try` of another kind
_USUAL = {
    "line": ("0", "0", "5", "-7", "-1", "6", "4"),
    "segment": ("0", "0", "5", "-7", "-1", "2", "2.5"),
    "ray": ("0", "0", "5", "-7", "-1", "6", "2.5"),
}
_PLACEHOLDER = re.compile(r"\{\{(\w+)\}\}")


def explored(part: Part, problem: Problem, values: Mapping[str, Any] | None) -> str | None:
    """The page that begins with that case, by parameter name, or with a usual one; None for other figures."""
    kind = _KINDS.get(part)
    if kind is None or [each.type.width for each in problem.parameters] != [1, 1, 1, 2, 2]:
        return None
    numbers = _USUAL[kind] if values is None else tuple(map(repr, _flat(values)))
    bands = {name: _ratio(problem, name) for name in ("snap", "clear")}
    start = {
        "kind": kind,
        "numbers": numbers,
        "bands": bands,
        "problems": {**_PROBLEMS, kind: problem.id},
        "called": "As it was opened" if values is None else "The case it was opened with",
    }
    script = "\n".join(_text(name) for name in ("exact.js", "drawing.js", "page.js"))
    inner = f"\n{script}\n"
    digest = b64encode(hashlib.sha256(inner.encode()).digest()).decode()
    parts = {
        "policy": f"default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{digest}'",
        "title": escape(f"{problem.id}, {problem.title}"),
        "css": _text("page.css"),
        "start": json.dumps(start).replace("<", "\\u003c"),
        "script": script,
    }
    return _PLACEHOLDER.sub(lambda found: parts[found[1]], _text("page.html"))


def _text(name: str) -> str:
    return (_FOLDER / name).read_text(encoding="utf-8").strip("\n")


def _flat(values: Mapping[str, Any]) -> list[Any]:
    return [
        number
        for value in values.values()
        for number in (value if isinstance(value, tuple | list) else [value])
    ]


def _ratio(problem: Problem, band: str) -> tuple[str, str]:
    """A band's width as numerator and denominator; 0 where the problem has none."""
    width = problem.bands.get(band)
    return ("0", "1") if width is None else (str(width.numerator), str(width.denominator))
