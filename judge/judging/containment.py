"""The boxes that submissions to one problem are judged in: how held, how many at once, what stays hidden."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from judge.errors import JudgeError, ShortageError
from judge.files import cache_folder
from judge.judging.isolation import kept_level
from judge.languages.boxes import AnyBoxes
from judge.languages.signature import signature_of
from judge.problem import Problem
from judge.problem.find import problem_roots
from judge.run.reference import Reference
from judge.sandbox import Boxes, room
from judge.sandbox.boundary import Box, BoxFactory

_SHORT = (ShortageError, OSError, MemoryError, RuntimeError)  # it shows when the box is needed
WEAK = "isolation is 'limits': submissions can read your files and use the network; see 'judge doctor'"


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


def room_for(jobs: int) -> tuple[int, str]:
    """How many things may be done at once in the room that is left, and why not as many as asked for."""
    room.raise_descriptors()
    fit, limit = room.measure().at_once(jobs)
    return fit, f"{fit} at once, not {jobs}: there is no room for more ({limit})" if limit else ""


class Containment:
    """The boxes of one session; a context manager that ends those that were never used.

    The first submission's box boots while the judge still reads its data. `open_box` opens another one at the
    same level.
    """

    def __init__(
        self,
        problem: Problem,
        level: str | None,
        jobs: int = 1,
        had: str | None = None,
        *,
        program: bool = False,
    ) -> None:
        """`level` is demanded; `had` is the level that this command has had before. `jobs` processes of this
        command judge at once, and share what the machine has left.

        With `program`, what is compiled is a program even where it defines the problem's function.
        """
        room.raise_descriptors()
        self._level = level
        least = None if level else kept_level()
        boxes = Boxes(level, hidden_folders(problem), least=least, had=had, share=room.measure().share(jobs))
        self.open_box: BoxFactory = AnyBoxes(boxes, None if program else signature_of(problem))
        self.reference = Reference(problem, self.open_box)
        self._ahead: dict[tuple[bytes, str], Box] = {}

    def __enter__(self) -> Containment:
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()

    def close(self) -> None:
        """End the boxes that are open or were started ahead."""
        self.reference.close()
        for box in self._ahead.values():
            box.__exit__(None, None, None)
        self._ahead.clear()

    def boot(self, source: bytes, name: str) -> None:
        """Start the box of a submission that will be judged soon."""
        with suppress(*_SHORT):
            box = self._ahead[source, name] = self.open_box(source, name)
            box.warm_up()

    def boot_reference(self) -> None:
        """Start the box of the reference, which will be wanted if a submission is accepted."""
        with suppress(*_SHORT):
            self.reference.warm_up()

    def take(self, source: bytes, name: str) -> Box:
        """The submission's box, started ahead or now."""
        return self._ahead.pop((source, name), None) or self.open_box(source, name)

    def notes(self, isolation: str) -> tuple[str, ...]:
        """A warning where a submission was held by limits only and nobody asked for that."""
        return (WEAK,) if isolation == "limits" and self._level is None else ()
