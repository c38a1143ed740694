"""The page of `judge try --open`: a kata's case to drag, decided exactly in the browser.

page.html, page.css, drawing.js and page.js are the page; figures.js and plane.js say what each kind of case
decides and comes to, in the exact arithmetic of exact.js. A test holds them against each kata's `solve`. The
page is one file that loads nothing.
"""

from __future__ import annotations

import hashlib
import json
import re
from base64 import b64encode
from collections.abc import Callable, Iterator, Mapping, Sequence
from html import escape
from pathlib import Path
from typing import Any

from judge.errors import UsageError
from judge.geometry import frames, motion, pair
from judge.geometry.crowd import PLACES
from judge.geometry.polygon import EDGE
from judge.geometry.quadratic import TANGENT, on_circle, tangent
from judge.geometry.shadow import AGAIN, LEVEL
from judge.geometry.sure import CLEAR, DecisionWords
from judge.problem import Parameter, Problem
from judge.problem.declare import InvalidCase, decisions
from judge.values import parameters

_FOLDER = Path(__file__).parent
_MOST = 600  # numbers that a page has fields for
_WORDS: Mapping[str, DecisionWords] = {
    "line": TANGENT,
    "edge": EDGE,
    "on": on_circle("{point}", "{figure}"),
    "tangent": tangent("{point}", "{figure}"),
    "places": PLACES,
    "level": LEVEL,
    "again": AGAIN,
    "outer": pair.OUTER,
    "inner": pair.INNER,
    "same": pair.SAME,
    "first": frames.FIRST,
    "threshold": frames.THRESHOLD,
}
_OF: Mapping[str, Mapping[str, DecisionWords]] = {  # words of the same name
    "balls": dict(zip(("start", "end", "touch"), (*motion.Discs.ends, motion.Discs.touch), strict=True)),
    "wall": dict(zip(("start", "end", "touch"), (*motion.Cap.ends, motion.Cap.touch), strict=True)),
}
_PLACEHOLDER = re.compile(r"\{\{(\w+)\}\}")


def explored(
    kind: str, problem: Problem, values: Mapping[str, Any] | None, solve: Callable[..., Any]
) -> str | None:
    """The page that begins with that case, by parameter name, or with the first example.

    None where the figure is not in the plane. Raises UsageError for a case of very many numbers.
    """
    if kind == "sphere":
        return None
    examples = [list(problem.named(example.case).values()) for example in problem.examples]
    cases = examples if values is None else [list(values.values()), *examples]
    numbers = sum(1 for _ in _flat(cases[0]))
    if numbers > _MOST:
        remedy = "explore a smaller one, such as the statement's examples"
        raise UsageError(f"the case has {numbers:,} numbers, and a page has {_MOST} at most", remedy=remedy)
    names = [f"Example {number}" for number in range(1, len(examples) + 1)]
    called = names if values is None else ["The case it was opened with", *names]
    reals = (
        real
        for example in problem.examples
        for parameter, value in zip(problem.parameters, example.case, strict=True)
        for atom, real in parameters.leaves(parameter.type, value)
        if atom.measured
    )
    start = {
        "problem": problem.id,
        "kind": kind,
        "args": [
            {
                "name": parameter.name,
                "value": _texts(value),
                "list": isinstance(value, list),
                "bounds": list(_bounds(parameter, value)),
            }
            for parameter, value in zip(problem.parameters, cases[0], strict=True)
        ],
        "cases": [[name, _texts(case)] for name, case in zip(called, cases, strict=True)],
        "whole": next(reals, None) is None,
        "same": _same(problem, examples[0], solve),
        "clear": CLEAR if _promises(examples, solve) else 0,
        "words": {
            name: [words.almost, *words.sides] for name, words in {**_WORDS, **_OF.get(kind, {})}.items()
        },
    }
    script = "\n".join(
        _text(name) for name in ("exact.js", "plane.js", "figures.js", "drawing.js", "page.js")
    )
    inner = f"\n{script}\n"
    digest = b64encode(hashlib.sha256(inner.encode()).digest()).decode()
    parts = {
        "policy": f"default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{digest}'",
        "title": escape(problem.title),
        "problem": escape(problem.id),
        "css": _text("page.css"),
        "start": json.dumps(start).replace("<", "\\u003c"),
        "script": script,
    }
    return _PLACEHOLDER.sub(lambda found: parts[found[1]], _text("page.html"))


def _text(name: str) -> str:
    return (_FOLDER / name).read_text(encoding="utf-8").strip("\n")


def _flat(value: Any) -> Iterator[Any]:
    if isinstance(value, list | tuple):
        for each in value:
            yield from _flat(each)
    else:
        yield value


def _texts(value: Any) -> Any:
    """The numbers as Python writes them."""
    return [_texts(each) for each in value] if isinstance(value, list | tuple) else repr(value)


def _bounds(parameter: Parameter, value: Any) -> Iterator[tuple[str, str]]:
    """The least and the greatest of each number; of a list, of those of an item."""
    for atom, _ in parameters.leaves(parameter.type, value[:1] if isinstance(value, list) else value):
        least, most = getattr(atom, "low", None), getattr(atom, "high", None)
        low = parameter.low if least is None else max(parameter.low, least)
        yield str(low), str(parameter.high if most is None else min(parameter.high, most))


def _promises(examples: Sequence[list[Any]], solve: Callable[..., Any]) -> bool:
    """Whether what is almost exact is no valid input: then `solve` decides by lengths."""
    with decisions() as made:
        for case in examples:
            solve(*case)
    return bool(made)


def _same(problem: Problem, example: Sequence[Any], solve: Callable[..., Any]) -> str | None:
    """What is wrong with a case where B is A, or None where that is a case."""
    values = {parameter.name: value for parameter, value in zip(problem.parameters, example, strict=True)}
    pairs = ("A", "B"), ("ax", "bx"), ("ay", "by")
    values.update({last: values[first] for first, last in pairs if first in values and last in values})
    try:
        solve(*values.values())
    except InvalidCase as broken:
        return str(broken)
    return None
