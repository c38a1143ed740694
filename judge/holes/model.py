"""What a search for holes is asked, what it says, and what is kept of it from run to run."""

from __future__ import annotations

from msgspec import Struct

from judge.errors import ExitCode
from judge.published import Published
from judge.verify.model import Fault


class Hole(Struct, frozen=True):
    """A mutant that the data accept, and a valid case on which it is wrong.

    `off` is the case's least gap that is not 0, null where nothing was decided; `way` is how the case was
    found, `row` a draw of such cases where one is known, `near` the case of the data that is most alike. The
    same case shows so many `others`.
    """

    file: str
    line: int
    kind: str
    was: str
    becomes: str
    case: str
    right: str
    given: str
    off: float | None
    way: str
    row: str
    near: str
    others: int


class Holes(Published, frozen=True):
    """What came of it; of the `accepted` mutants `edge` are wrong only at the very edge of the promise.

    `unknown` are those without any witness, each a line of `unwitnessed`, and `marked` those that same.toml
    says to be right. `stopped` says that Ctrl-C ended the search, `notes` what else a person should know.
    """

    problem: str
    programs: int = 0
    mutants: int = 0
    rejected: int = 0
    accepted: int = 0
    marked: int = 0
    cases: int = 0
    holes: tuple[Hole, ...] = ()
    edge: int = 0
    unknown: int = 0
    unwitnessed: tuple[str, ...] = ()
    faults: tuple[Fault, ...] = ()
    notes: tuple[str, ...] = ()
    stopped: bool = False

    @property
    def exit_code(self) -> ExitCode:
        """3 where there is a hole."""
        return ExitCode.FAULT if self.holes or self.faults else ExitCode.ACCEPTED


class Kept(Struct):
    """What is known of the search of one seed, the turns and cases that it tried; a case is Python."""

    witnesses: dict[str, tuple[str, str, str]] = {}  # by mutant: a case, its way, its row
    near: list[str] = []  # cases worth changing
    turns: int = 0
    cases: int = 0


class HoleSearch(Struct, frozen=True):
    """How to look: the seed of the cases, so long or at so many more of them, and at which program alone."""

    seed: int = 0
    seconds: float = 30.0
    cases: int = 1 << 60
    program: str = ""
