"""How to judge, whatever is judged."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct, field

from judge.run.parallel import Turnstile
from judge.run.reference import Reference
from judge.sandbox.boundary import BoxFactory
from judge.sandbox.factory import Boxes

Progress = Callable[[int, int], None]  # cases done, cases in all


class Settings(Struct, frozen=True):
    """How to judge, whatever is judged.

    `box_factory` opens the containment; `workers` is how many boxes one submission may use at once;
    `measured` says whether an accepted one is raced against the reference; `turnstile` keeps races alone;
    `reference` is there where several submissions share it; a `program` is run as one even where it defines
    the problem's function.
    """

    box_factory: BoxFactory = field(default_factory=Boxes)
    workers: int = 1
    measured: bool = True
    turnstile: Turnstile | None = None
    reference: Reference | None = None
    program: bool = False
