"""Rows of the setter's own, with other literals: what draws a case of a new kind is often one number away."""

from __future__ import annotations

import ast
import copy
import gc
import re
import runpy
import signal
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from random import Random
from typing import Any

from judge.data import ProblemData
from judge.data.draw import Draw, Rejected, quick
from judge.problem import Case

_CASES = 12  # of a changed row
_SECONDS = 0.3  # that it may take: some never end


class Rows:
    """The draws of problem.py as they are written, of which a literal is changed."""

    def __init__(self, data: ProblemData, seed: int) -> None:
        self._problem = data.problem
        path = data.problem.folder / "problem.py"
        self._names = runpy.run_path(str(path))
        nodes = ast.walk(ast.parse(path.read_text("utf-8")))
        rows = [node.args[2] for node in nodes if isinstance(node, ast.Call) and _is_row(node)]
        spots = [(row, self._spots(row)) for row in rows]
        self._literals = [node for _, some in spots for node in some]
        self._singles = [(row, at, way) for row, some in spots for at in range(len(some)) for way in range(9)]
        Random(seed).shuffle(self._singles)

    def _spots(self, row: ast.AST) -> list[ast.Constant | ast.Name]:
        """What may be changed: literals, and names of poses and words."""
        return [
            node
            for node in ast.walk(row)
            if isinstance(node, ast.Constant)
            or (isinstance(node, ast.Name) and isinstance(self._names.get(node.id), dict | tuple))
        ]

    def turn(self, random: Random, number: int) -> tuple[str, list[Case]]:
        """The changed row of that number, and a dozen cases of it."""
        if not self._singles:
            return "", []
        rounds, at = divmod(number, len(self._singles))
        row, *single = self._singles[at]
        row = copy.deepcopy(row)
        more = random.choice((0, 0, 1, 2)) if rounds else 0
        spots = self._spots(row)
        others = [(random.randrange(len(spots)), random.randrange(9)) for _ in range(more)]
        for spot, way in (single, *others):
            self._change(random, spots[spot], way)
        text = ast.unparse(row)
        if random.random() < 0.5:
            for name in sorted({each.id for each in self._spots(row) if isinstance(each, ast.Name)}):
                text = re.sub(rf"\b{name}\b", self._grown(random, name), text)
        cases: list[Case] = []
        with suppressed_after(_SECONDS):
            draw_case = eval(text, dict(self._names))
            for _ in range(_CASES):
                with suppress(Rejected):
                    cases.append(self._problem.kept(draw_case(Draw(quick(str(random.random()))))))
        return text, cases

    def _change(self, random: Random, node: ast.Constant | ast.Name, way: int) -> None:
        """Another literal in its place, of the same type."""
        other: Any = random.choice([each for each in self._literals if self._kind(each) == self._kind(node)])
        if isinstance(node, ast.Name):
            node.id = other.id
        elif type(node.value) is int:
            n = node.value
            node.value = (2 * n, n * 10, n + n // 8 + 1, n + n // 5, n // 2, -n, n + 1, n - 1, 0)[way]
        elif isinstance(node.value, str) and node.value.split() and other.value.split() and way < 6:
            words = node.value.split()  # one word of it alone
            words[random.randrange(len(words))] = random.choice(other.value.split())
            node.value = " ".join(words)
        else:
            node.value = other.value

    def _kind(self, node: ast.Constant | ast.Name) -> tuple[bool, type]:
        if isinstance(node, ast.Name):
            return True, type(self._names[node.id])
        return False, type(node.value)

    def _grown(self, random: Random, name: str) -> str:
        """The name of a pose, with some of its ints changed: {**NEAR, 'size': 8192} for NEAR."""

        def grown(value: Any) -> Any:
            if type(value) is tuple:
                return tuple(map(grown, value))
            if type(value) is not int or random.random() > 0.2:
                return value
            return random.choice((2 * value, value + 5, value - 5, -value, value // 2, 0))

        pose = self._names[name]
        pairs = [(key, grown(value)) for key, value in pose.items()] if isinstance(pose, dict) else []
        changed = "".join(f", {key!r}: {value!r}" for key, value in pairs if value != pose[key])
        return f"{{**{name}{changed}}}" if changed else name


def _is_row(call: ast.Call) -> bool:
    """Whether it declares a group without a size: group(name, about, draw, …)."""
    sized = any(each.arg == "size" for each in call.keywords)
    return getattr(call.func, "id", "") == "group" and len(call.args) > 2 and not sized


@contextmanager
def suppressed_after(seconds: float) -> Iterator[None]:
    """Whatever is raised inside is nothing, and so is what takes longer than that of CPU.

    What a signal raises in the middle of collecting garbage is lost: that waits, and the signal comes again.
    """

    def late(*_: object) -> None:
        raise TimeoutError

    before, collects = signal.signal(signal.SIGVTALRM, late), gc.isenabled()
    gc.disable()
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds, seconds)
    try:
        yield
    except Exception:  # no such row can be drawn
        return
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
        if collects:
            gc.enable()
