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
from contextlib import nullcontext, suppress
from functools import partial
from pathlib import Path
from typing import Any, Protocol, TypeVar

import msgspec

from judge.cache import decoded
from judge.data.load import ProblemData, load_data
from judge.diagnose.shrink import shrink
from judge.errors import JudgeError, told
from judge.mistakes.namer import Namer
from judge.problem import Problem, Verdict
from judge.problem.declare import Shown
from judge.problem.load import load_problem
from judge.problem.model import case_of
from judge.report.tell import shown_failure, tell
from judge.run.execute import judge_submission
from judge.run.group import one_case
from judge.run.hurdle import with_hurdle
from judge.run.printed import with_printed
from judge.run.reference import Reference
from judge.run.result import Behaviour, Result, judge_fault
from judge.run.settings import Settings
from judge.site.box import TabBox

if not hasattr(os, "geteuid"):  # what Emscripten lacks
    os.geteuid = os.getuid

T = TypeVar("T")
NAME = "yours.py"
_NAMED = (Verdict.WA, Verdict.RTE)
_START = re.compile(r'<script type="application/json" id="start">(.*?)</script>', re.DOTALL)


class Page(Protocol):
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

    def __init__(self, page: Page, folder: str = "/katas") -> None:
        self._page, self._folder = page, Path(folder)
        self._katas: dict[str, _Kata] = {}

    def open(self, kata: str) -> None:
        """Read a kata, and import what judging needs. Raises JudgeError."""
        self._katas[kata] = opened = _Kata(self._folder / kata, kata, self._page)
        opened.judge(f"def {opened.problem.entry}(*_): pass".encode(), explained=False)

    def judge(self, kata: str, source: str) -> str:
        """Judge a program, as JSON: `judge.report.tell.Told`, and what the page does with it besides."""
        return self._katas[kata].judge(source.encode("utf-8", "surrogatepass"))

    def result(self, kata: str, source: bytes) -> Result:
        """The whole result. Raises JudgeError."""
        return self._katas[kata].result(source)


class _Kata:
    def __init__(self, folder: Path, name: str, page: Page) -> None:
        self._page, self._store = page, Shipped(folder)
        self.problem = load_problem(folder / "problems" / name)
        self._data = load_data(self.problem, store=self._store)
        self._open = partial(TabBox, memory=page.memory, alive=page.alive)
        self._settings = Settings(self._open, measured=False)
        self._reference = Reference(self.problem, self._open)
        self._namer: Namer | None = None

    def judge(self, source: bytes, *, explained: bool = True) -> str:
        """See `Tab.judge`."""
        try:
            result = self.result(source, explained=explained)
        except JudgeError as fault:
            result = judge_fault(self.problem.id, NAME, told(fault))
        return self._told(result, source, drawn=True)

    def result(self, source: bytes, *, explained: bool = True) -> Result:
        """As `judge.judging.session.Session.judge`, without races. Raises JudgeError."""
        with self._open(source, NAME) as box:
            result, runner, does = judge_submission(
                self._data, source, NAME, self._settings, box=box, on_progress=self._page.progress
            )
            if runner is None or not explained:
                return result
            result = with_hurdle(result, runner, box, source)
            if result.hurdle is not None or result.failure is None:
                return result
            result = with_printed(result, self._data, runner, box)
            self._page.told(self._told(result, source, drawn=False))
            smallest = shrink(self._data, box, runner, result, reference=self._reference)
        if smallest is not None:
            smallest = runner.explained(smallest, does) if smallest.replay is not None else smallest
            result = msgspec.structs.replace(result, counterexample=smallest)
        return self._named(result, does, source) if result.verdict in _NAMED else result

    def _named(self, result: Result, does: Behaviour, source: bytes) -> Result:
        if self._namer is None:
            self._namer = Namer(self._data, None, self._settings, nullcontext, store=self._store)

        def alone(group: str, case: int) -> bool:
            found = judge_submission(one_case(self._data, group, case), source, NAME, self._settings)
            return found.result.verdict is not Verdict.AC

        return self._namer.named(result, does, source, alone)

    def _told(self, result: Result, source: bytes, *, drawn: bool) -> str:
        found: dict[str, Any] = msgspec.to_builtins(tell(self.problem, result, source))
        found["solved"] = result.solved
        found["line"] = result.hurdle.line if result.hurdle else 0
        found |= _drawn(self.problem, self._data, result) if drawn else {}
        return json.dumps(found)


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
        Shown(problem, failure.input, exact, failure.expected, failure.got, failure.given, "")
    )
    page = hooks.explore(problem, failure.input) if hooks.explore else None
    start = _START.search(page) if page else None
    case = [each["value"] for each in json.loads(start[1])["args"]] if start else None
    found: dict[str, Any] = {"explore": json.dumps(case or "")}
    if picture is not None:
        found["drawn"] = words = picture.description
        found["drawings"] = [
            {"title": panel.title, "svg": panel_svg(panel, f"panel-{at}", words, alone=True)}
            for at, panel in enumerate(picture.panels)
        ]
    return found
