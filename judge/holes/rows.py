"""Rows of the setter's own, with other literals: what draws a case of a new kind is often one number away."""

from __future__ import annotations

import ast
import copy
import gc
import runpy
import signal
from collections.abc import Iterator
from contextlib import contextmanager
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
        draws = [node.args[2] for node in nodes if isinstance(node, ast.Call) and _is_row(node)]
        self._rows = [draw for draw in draws if self._spots(draw)]
        self._literals = [node for row in self._rows for node in self._spots(row)]
        self._singles = [
            (row, at, way) for row in self._rows for at in range(len(self._spots(row))) for way in range(9)
        ]
        Random(seed).shuffle(self._singles)

    def _spots(self, row: ast.AST) -> list[ast.Constant | ast.Name]:
        """What may be changed: literals, and names of poses and words."""
        return [
            node
            for node in ast.walk(row)
            if isinstance(node, ast.Constant)
            or (isinstance(node, ast.Name) and isinstance(self._names.get(node.id), dict | tuple))
        ]

    def turn(self, random: Random, number: int) -> Iterator[tuple[Case, str]]:
        """A dozen cases of the changed row of that number."""
        if not self._singles:
            return
        rounds, at = divmod(number - 1, len(self._singles))
        row, *single = self._singles[at]
        row = copy.deepcopy(row)
        more = random.choice((0, 0, 1, 2)) if rounds else 0
        spots = self._spots(row)
        for spot, way in (
            single,
            *((random.randrange(len(spots)), random.randrange(9)) for _ in range(more)),
        ):
            self._change(random, spots[spot], way)
        if random.random() < 0.5:
            row = _Grown(random, self._names).visit(row)
        text = ast.unparse(row)
        for case in self._drawn(random, text):
            yield case, text

    def _drawn(self, random: Random, text: str) -> list[Case]:
        cases: list[Case] = []
        with suppressed_after(_SECONDS):
            draw_case = eval(compile(text, "row", "eval"), dict(self._names))
            for _ in range(_CASES):
                try:
                    cases.append(self._problem.kept(draw_case(Draw(quick(str(random.random()))))))
                except Rejected:
                    continue
        return cases

    def _change(self, random: Random, node: ast.Constant | ast.Name, way: int) -> None:
        """Another literal in its place, of the same type."""
        other = random.choice([each for each in self._literals if self._kind(each) == self._kind(node)])
        if isinstance(node, ast.Name):
            assert isinstance(other, ast.Name)
            node.id = other.id
        elif type(node.value) is int:
            n = node.value
            node.value = (2 * n, n * 10, n + n // 8 + 1, n + n // 5, n // 2, -n, n + 1, n - 1, 0)[way]
        elif isinstance(node.value, str) and node.value and way < 6:  # one word of it alone
            assert isinstance(other, ast.Constant)
            words, others = node.value.split(), str(other.value).split()
            if words and others:
                words[random.randrange(len(words))] = random.choice(others)
                node.value = " ".join(words)
        else:
            assert isinstance(other, ast.Constant)
            node.value = other.value

    def _kind(self, node: ast.Constant | ast.Name) -> tuple[bool, type]:
        if isinstance(node, ast.Name):
            return True, type(self._names[node.id])
        return False, type(node.value)


def _is_row(call: ast.Call) -> bool:
    """Whether it declares a group without a size: group(name, about, draw, …)."""
    sized = any(each.arg == "size" for each in call.keywords)
    return getattr(call.func, "id", "") == "group" and len(call.args) > 2 and not sized


class _Grown(ast.NodeTransformer):
    """Names of poses with some of their ints changed: {**NEAR, 'size': 8192} for NEAR."""

    def __init__(self, random: Random, names: dict[str, Any]) -> None:
        self._random, self._names = random, names

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """The name, or a dictionary of it with other values."""
        pose = self._names.get(node.id)
        if not isinstance(pose, dict):
            return node
        other = {key: grown for key, value in pose.items() if (grown := self._grown(value)) != value}
        if not other:
            return node
        keys: list[ast.expr | None] = [None, *map(ast.Constant, other)]
        return ast.Dict(keys, [node, *(ast.parse(repr(value), mode="eval").body for value in other.values())])

    def _grown(self, value: Any) -> Any:
        if type(value) is tuple:
            return tuple(map(self._grown, value))
        if type(value) is not int or self._random.random() > 0.2:
            return value
        return self._random.choice((2 * value, value + 5, value - 5, -value, value // 2, 0))


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
