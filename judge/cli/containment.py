"""The containment a command judges in: the level, how many at once, what stays hidden, the warnings."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

import click

from judge.cli.isolation import kept_level
from judge.data import cache_folder
from judge.errors import JudgeError, ShortageError
from judge.report.screen import note
from judge.run import Mode, Reference, Settings
from judge.run.parallel import Turnstile
from judge.sandbox import LEVELS, Box, Boxes, BoxFactory, room
from judge.spec import Problem
from judge.spec.find import problem_roots

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
    with suppress(OSError):  # whoever builds the data says so
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
    another one at the same level; `jobs` is how many things may be done at once here.
    """

    def __init__(self, problem: Problem, level: str | None, jobs: int = 1, had: str | None = None) -> None:
        """`level` is demanded, `jobs` are asked for; `had` is the level that this command has had before."""
        hidden = hidden_folders(problem)
        room.raise_descriptors()
        left = room.measure()
        self.jobs, limit = left.at_once(jobs)
        if limit:
            note(f"{self.jobs} at once, not {jobs}: there is no room for more ({limit})")
        self._level = level
        self._kept = None if level else kept_level()
        self._boxes = Boxes(level, hidden, least=self._kept, had=had, share=left.share(self.jobs))
        self.open_box: BoxFactory = self._boxes
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
        with suppress(ShortageError, OSError, MemoryError, RuntimeError):  # it shows when they are needed
            box = self._ahead[source, name] = self.open_box(source, name)
            box.warm_up()
            reference = self._reference.open(Mode.FUNCTION)
            if reference is not None:
                reference.warm_up()

    def settings(self, *, submissions: int) -> Settings:
        """How to judge so many submissions with `jobs` at once."""
        return Settings(
            box_factory=self._take,
            workers=max(1, self.jobs // max(1, submissions)),
            turnstile=Turnstile(),
            reference=self._reference,
        )

    def warn_of(self, isolation: str) -> None:
        """Say once, in one line, that the containment is weaker than it might be, unasked."""
        text = self._warning(isolation)
        if text and not self._warned:
            self._warned = True
            note(text)

    def _warning(self, isolation: str) -> str:
        if self._level is not None:
            return ""
        if isolation == "limits":
            what = "submissions can read your files and use the network"
            return f"isolation is 'limits': {what}; see 'judge doctor'"
        reason = self._boxes.refused.get("full")
        if isolation == "strong" and self._kept != "strong" and reason:
            return f"isolation is 'strong', not 'full': {reason}; 'judge doctor' says more and settles for it"
        return ""

    def _take(self, source: bytes, name: str) -> Box:
        return self._ahead.pop((source, name), None) or self.open_box(source, name)
