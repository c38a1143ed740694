"""What questions are made from: problems, their exact answers and wrong programs, and chance."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING

from judge.problem import Problem
from judge.problem.find import find_problem

if TYPE_CHECKING:
    from judge.data.draw import Draw
    from judge.data.model import ProblemData, Progress
    from judge.problem.module import Module

Bars = Callable[[str], AbstractContextManager["Progress | None"]]  # opens a bar for work of that label


class Sources:
    """Problems are read, and their code is run, when a question asks for them; each once."""

    def __init__(self, folders: Sequence[Path], seed: int, bars: Bars) -> None:
        self.folders = folders
        self.seed = seed
        self._bars = bars
        self._problems: dict[str, Problem] = {}
        self._modules: dict[str, Module] = {}
        self._data: dict[str, ProblemData] = {}

    def draw(self, what: str) -> Draw:
        """Chance that depends on the seed and on `what` it is for."""
        from judge.data.draw import SeededDraw

        return SeededDraw(f"quiz/{self.seed}/{what}")

    def problem(self, name: str) -> Problem:
        """The problem of that name. Raises UsageError and ProblemError as find_problem does."""
        if name not in self._problems:
            self._problems[name] = find_problem(name, self.folders)
        return self._problems[name]

    def module(self, name: str) -> Module:
        """What the problem's problem.py defines. Raises ProblemError."""
        from judge.problem.module import load_module

        if name not in self._modules:
            self._modules[name] = load_module(self.problem(name))
        return self._modules[name]

    def data(self, name: str) -> ProblemData:
        """The problem's test data. Raises ProblemError."""
        from judge.data.load import load_data

        if name not in self._data:
            with self._bars(f"building the data of {name}") as progress:
                self._data[name] = load_data(self.problem(name), progress=progress)
        return self._data[name]
