"""The simplest case that a submission gets wrong, ready to be shown, written as JSON and judged again."""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from judge.problem import Case
from judge.values import Raw


class Counterexample(Struct, frozen=True):
    """A case and how it fails.

    `input` maps a parameter's name to its value; `given` is the answer itself, as the
    submission sent it; `group` is the test group whose tolerance decides. `replay` is the id to judge just
    this case by; it is None where the case fails only after other calls, and then `message` says so. `calls`
    counts what the search asked of the submission; `cut_short` says that it had not come to its end.
    `printed` is what the function printed on the case, as in `Failure`.
    """

    case: Case
    group: str
    input: dict[str, Any]
    expected: str
    got: str
    message: str
    replay: str | None
    calls: int = 0
    given: Raw = None
    cut_short: bool = False
    printed: str = ""

    @classmethod
    def from_json(cls, found: dict[str, Any]) -> Counterexample:
        """The counterexample that `as_json` wrote; it must have a replay id."""
        case = tuple(tuple(value) if isinstance(value, list) else value for value in found["input"].values())
        return cls(case, found["replay"].split(":")[1], **found)

    def as_json(self) -> dict[str, Any]:
        """The counterexample's object in the published form; of the last two only what says something."""
        found = {
            "input": self.input,
            "expected": self.expected,
            "got": self.got,
            "message": self.message,
            "replay": self.replay,
        }
        cut: dict[str, Any] = {"cut_short": True} if self.cut_short else {}
        return found | ({"printed": self.printed} if self.printed else {}) | cut
