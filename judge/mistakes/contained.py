"""Whether trusted programs answer in containment as they do here: all of them in one container.

A container of its own for each would take longer than its answers. They are the setter's own code, so that
one may know of another; each still has a process to itself.

What is no plain match is nobody's fault yet: the program may have ended its process, or taken longer than one
group may. Whoever asked judges that program by itself.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from types import TracebackType
from typing import Any

from judge.data.model import ProblemData
from judge.mistakes.computed import Ends, Program, raised, written
from judge.problem import Problem
from judge.problem.program import tree_of
from judge.run.group import group_limits
from judge.sandbox import Box, BoxFactory, Reply, Stop, Usage

_NAME = "mistakes.py"
_ENTRIES = """
def _entry(source):
    made = []

    def entry(*arguments):
        if not made:
            space = {"__name__": "submission"}
            exec(compile(source, "mistake", "exec", dont_inherit=True), space)
            made.append(space[_ENTRY])
        return made[0](*arguments)

    return entry


for _place, _source in enumerate(_SOURCES):
    globals()[f"program_{_place}"] = _entry(_source)
"""


class Contained:
    """The programs in their container; a context manager.

    Groups of big cases are left out, as a `Computer` does.
    """

    def __init__(self, data: ProblemData, programs: Sequence[Program], box_factory: BoxFactory) -> None:
        problem = data.problem
        groups = [each for each in data.groups if each.group.size is None]
        self._names = [each.group.name for each in groups]
        self._calls = [problem.calls(each.cases) for each in groups]
        self._limits = [group_limits(problem, each.group, Usage()) for each in groups]
        self._places = {each.key: place for place, each in enumerate(programs)}
        self._box: Box = box_factory(_module(problem, programs), _NAME)

    def __enter__(self) -> Contained:
        self._box.__enter__()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._box.__exit__(kind, fault, trace)

    def agrees(self, program: Program, here: Ends) -> bool:
        """Whether it answers every case as it did here. Raises JudgeError where nothing can be run."""
        entry = f"program_{self._places[program.key]}"
        waiting = list(zip(self._names, self._calls, strict=True))
        while waiting:
            limits = min(self._limits, key=lambda each: (each.cpu_seconds, each.wall_seconds))
            results = self._box.call_series(entry, [calls for _, calls in waiting], limits)
            if not results:
                return False
            for (name, _), result in zip(waiting, results, strict=False):
                if written([_end(each) for each in result.replies]) != here[name]:
                    return False
            waiting = waiting[len(results) :]
        return True


def _end(reply: Reply) -> Any:
    """A call's end as `Ends` has it; any but an answer and an exception is like none of these."""
    if reply.stop is Stop.ANSWERED:
        return reply.answer
    return raised(re.split("[: ]", reply.detail)[0]) if reply.stop is Stop.EXCEPTION else reply


def _module(problem: Problem, programs: Sequence[Program]) -> bytes:
    """One module with an entry for each program, which is compiled when it is first called."""
    sources = [each.source for each in programs]
    ahead = "".join(f"    import {name}\n" for name in sorted(set(_imported(sources))))
    imports = f"if False:\n{ahead}" if ahead else ""  # so that the container has them ready
    return f"{imports}_ENTRY = {problem.entry!r}\n_SOURCES = {sources!r}\n{_ENTRIES}".encode()


def _imported(sources: Iterable[bytes]) -> Iterator[str]:
    for source in sources:
        for node in ast.walk(_tree(source)):
            if isinstance(node, ast.Import):
                yield from (alias.name for alias in node.names)
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                yield node.module


def _tree(source: bytes) -> ast.Module:
    """What a program is; nothing, where it is no Python, which its first call says."""
    try:
        return tree_of(source)
    except SyntaxError:
        return ast.Module([], [])
