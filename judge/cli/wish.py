"""What a person who has submissions judged asks for."""

from __future__ import annotations

from pathlib import Path

from msgspec import Struct

from judge.judging.api import RunOptions


class Wish(Struct, frozen=True):
    """How submissions are to be judged, and what is kept of them."""

    options: RunOptions
    jobs: int = 1
    had: str | None = None  # the level of isolation that the command has had before
    kept: bool = True  # in the history
    db: Path | None = None
    total: int = 1  # submissions, to all problems
    before: int = 0  # those among them that were judged already
