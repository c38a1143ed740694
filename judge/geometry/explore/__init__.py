"""The page of `judge explore`: a circle and a line, segment or ray to drag, decided exactly in the browser.

page.html, page.css, drawing.js and page.js are the page; exact.js is its arithmetic, in BigInt, which a test
holds against judge.geometry.Line. One file comes out, which loads nothing.
"""

from __future__ import annotations

import hashlib
import json
import re
from base64 import b64encode
from collections.abc import Callable, Mapping
from html import escape
from pathlib import Path
from typing import Any

from judge.geometry.sure import CLEAR
from judge.problem import Problem
from judge.problem.declare import InvalidCase

_FOLDER = Path(__file__).parent
_KINDS = {
    **dict.fromkeys(("line", "points", "chord"), "line"),
    **dict.fromkeys(("segment", "count in a segment"), "segment"),
    **dict.fromkeys(("ray", "normal", "reflection"), "ray"),
}
_PROBLEMS = {"line": "count", "segment": "segment", "ray": "ray-nearest"}  # for `judge try` of another kind
_USUAL = {
    "line": ("0", "0", "5", "-7", "-1", "6", "4"),
    "segment": ("0", "0", "5", "-7", "-1", "2", "2.5"),
    "ray": ("0", "0", "5", "-7", "-1", "6", "2.5"),
}
_PLACEHOLDER = re.compile(r"\{\{(\w+)\}\}")


def explored(
    view: str, problem: Problem, values: Mapping[str, Any] | None, solve: Callable[..., Any]
) -> str | None:
    """The page that begins with that case, by parameter name, or with a usual one; None for other figures."""
    kind = _KINDS.get(view)
    if kind is None or [each.type.width for each in problem.parameters] != [1, 1, 1, 2, 2]:
        return None
    numbers = _USUAL[kind] if values is None else tuple(map(repr, _flat(values)))
    start = {
        "kind": kind,
        "numbers": numbers,
        "clear": ("1", str(CLEAR)) if _promises(kind, solve) else ("0", "1"),
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


def _promises(kind: str, solve: Callable[..., Any]) -> bool:
    """Whether what almost touches is no valid input: not where whole numbers of any size decide."""
    size = 10**9
    far = (1, 0) if kind == "ray" else (size, size + 1)
    try:
        solve(0, 0, size, (-size, size + 1), far)
    except InvalidCase:
        return True
    return False
