"""The containment a command judges in: the level asked for, what stays hidden, the warning when weak."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from judge.data import cache_folder
from judge.errors import JudgeError
from judge.problem import Problem
from judge.problem.find import problem_roots
from judge.report.screen import note
from judge.run import Mode, Reference, Settings
from judge.run.parallel import Turnstile
from judge.sandbox import LEVELS, Box, Boxes, BoxFactory

F = TypeVar("F", bound=Callable[..., Any])

isolation_option: Callable[[F], F] = click.option(
    "--isolation",
    "level",
    metavar="LEVEL",
    type=click.Choice(LEVELS),
    help="Demand full, strong or limits; without it, the best there is. See 'judge doctor'.",
)
jobs_option: Callable[[F], F] = click.option(
    "-j",
    "--jobs",
    type=click.IntRange(1, 256),
    default=1,
    metavar="N",
    help="Do so many things at once; time is still measured alone.",
)


def hidden_folders(problem: Problem) -> tuple[Path, ...]:
    """What a submission to the problem must not see; the cache is made first, or it could not be covered."""
    cache = cache_folder()
    with contextlib.suppress(OSError):  # whoever builds the data says so
        cache.mkdir(parents=True, exist_ok=True)
    own = (problem.folder, problem.solutions)  # they may be symlinks to another place than their parents
    return (*own, *(folder.parent for folder in own), cache)


def every_hidden_folder() -> tuple[Path, ...]:
    """What a submission to any problem that can be found must not see; nothing of packs that are broken."""
    try:
        roots = problem_roots()
    except JudgeError:
        roots = []
    return (*roots, *(root.parent / "solutions" for root in roots), cache_folder())


class Containment:
    """The boxes of one command; a context manager that ends those that were never used.

    The first submission's box and the reference's boot while the judge still reads its data. `open_box` opens
    another one at the same level.
    """

    def __init__(self, problem: Problem, level: str | None) -> None:
        self.open_box: BoxFactory = Boxes(level, hidden_folders(problem))
        self._level = level
        self._ahead: dict[tuple[bytes, str], Box] = {}
        self._reference = Reference(problem, self.open_box)
        self._warned = False

    def __enter__(self) -> Containment:
        return self

    def __exit__(self, *exc: object) -> None:
        self._reference.__exit__(*exc)
        for box in self._ahead.values():
            box.__exit__(*exc)

    def boot(self, source: bytes, name: str) -> None:
        """Start the box of a submission that will be judged soon, and that of the reference."""
        box = self._ahead[source, name] = self.open_box(source, name)
        box.warm_up()
        reference = self._reference.open(Mode.FUNCTION)
        if reference is not None:
            reference.warm_up()

    def settings(self, *, jobs: int, submissions: int) -> Settings:
        """How to judge so many submissions with `jobs` at once."""
        return Settings(
            box_factory=self._take,
            workers=max(1, jobs // max(1, submissions)),
            turnstile=Turnstile(),
            reference=self._reference,
        )

    def warn_of(self, isolation: str) -> None:
        """Say once, in one line, that the containment is weak and nobody asked for that."""
        if isolation != "limits" or self._level is not None or self._warned:
            return
        self._warned = True
        text = (
            "isolation is 'limits': submissions can read your files and use the network; see 'judge doctor'"
        )
        note(text)

    def _take(self, source: bytes, name: str) -> Box:
        return self._ahead.pop((source, name), None) or self.open_box(source, name)
