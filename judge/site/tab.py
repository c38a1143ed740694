"""The judge in a browser's worker: what python.js calls. It also runs in CPython, which its tests do.

A kata is a folder that `judge site` has made, unpacked:

    problems/<id>/ solutions/<id>/ …    as the judge has them
    data.json mistakes.json             what the cache holds: the cases, and what known mistakes answer
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from contextlib import AbstractContextManager, nullcontext, suppress
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Any, Protocol, TypeVar

import msgspec

from judge.cache import decoded
from judge.data import ProblemData
from judge.judging import RunOptions
from judge.judging.session import Session
from judge.problem import Problem
from judge.problem.declare import Shown
from judge.problem.load import load_problem
from judge.problem.model import case_of
from judge.report.tell import shown_failure, tell
from judge.run.execute import judge_submission
from judge.run.result import Result
from judge.run.settings import Progress
from judge.site.box import TabBox

if not hasattr(os, "geteuid"):  # what Emscripten lacks
    os.geteuid = os.getuid

T = TypeVar("T")
NAME = "yours.py"
_START = re.compile(r'<script type="application/json" id="start">(.*?)</script>', re.DOTALL)


class Listener(Protocol):
    """What the worker hears of the work."""

    def alive(self) -> None:
        """It goes on."""

    def memory(self) -> int:
        """The bytes that the interpreter has."""

    def progress(self, done: int, cases: int) -> None:
        """So many cases are judged."""

    def told(self, text: str) -> None:
        """The verdict, before it is explained; JSON as `Tab.judge` returns it."""


class Shipped:
    """A `judge.cache.Store` of what came with the kata, whatever it was keyed by; nothing is added."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def read(self, name: str, _key: str, kind: type[T]) -> T | None:
        """What the site brought, as that type."""
        with suppress(OSError, ValueError):
            return decoded((self._folder / f"{name.partition('/')[0]}.json").read_bytes(), kind)
        return None

    def write(self, _name: str, _key: str, _value: Any, _what: str = "") -> str | None:
        """Nothing is kept."""
        return None


class Tab:
    """The katas that were opened. `page` hears of the work; `folder` holds the katas."""

    def __init__(self, page: Listener, folder: str = "/katas") -> None:
        self._page, self._folder = page, Path(folder)
        self._katas: dict[str, Session] = {}

    def open(self, kata: str) -> None:
        """Read a kata, and judge something, which imports all that judging takes. Raises JudgeError."""
        place = self._folder / kata
        problem = load_problem(place / "problems" / kata)
        boxes = partial(TabBox, memory=self._page.memory, alive=self._page.alive)
        self._katas[kata] = session = Session(
            problem, RunOptions(timed=False), boxes=boxes, bars=self._bar, store=Shipped(place)
        )
        source = f"def {problem.entry}(*_): pass".encode() if problem.entry else b""
        judge_submission(session.data, source, NAME, session.settings)

    def judge(self, kata: str, source: str) -> str:
        """Judge a program, as JSON: `judge.report.tell.Told`, and what the page does with it besides."""
        session, text = self._katas[kata], source.encode("utf-8", "surrogatepass")
        result = session.judge(text, NAME, lambda first: self._page.told(_told(session, first, text)))
        return _told(session, result, text, _drawn(session.problem, session.data, result))

    def result(self, kata: str, source: bytes) -> Result:
        """The whole result."""
        return self._katas[kata].judge(source, NAME)

    def _bar(self, label: str) -> AbstractContextManager[Progress | None]:
        return nullcontext(self._page.progress if label == NAME else None)


def _told(
    session: Session, result: Result, source: bytes, drawn: Mapping[str, Any] = MappingProxyType({})
) -> str:
    told = tell(session.problem, result, source, drawn.get("why", ""))
    line = result.hurdle.line if result.hurdle else 0
    return json.dumps({**msgspec.to_builtins(told), "solved": result.solved, "line": line, **drawn})


def _drawn(problem: Problem, data: ProblemData, result: Result) -> Mapping[str, Any]:
    """The failing case as drawings, in words, and for the page where it is dragged."""
    from judge.drawing.svg import panel_svg  # only after a failure

    failure, hooks = shown_failure(result), data.module.hooks
    if failure is None or not failure.input or hooks.picture is None or result.hurdle is not None:
        return {}
    group = problem.group(failure.group or (result.failure.group if result.failure else "") or "")
    if group is None:
        return {}
    exact, _ = data.exact(case_of(failure.input), group)
    picture = hooks.picture(
        Shown(problem, failure.input, exact, failure.expected, failure.got, failure.given)
    )
    page = hooks.explore(problem, failure.input) if hooks.explore else None
    start = _START.search(page) if page else None
    case = [each["value"] for each in json.loads(start[1])["args"]] if start else None
    found: dict[str, Any] = {"explore": json.dumps(case or "")}
    if picture is not None:
        found["why"], found["drawn"] = picture.why, (words := picture.description)
        found["drawings"] = [
            {"title": panel.title, "svg": panel_svg(panel, f"panel-{at}", words, alone=True)}
            for at, panel in enumerate(picture.panels)
        ]
    return found
