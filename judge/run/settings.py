"""How to judge, whatever is judged."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct, field

from judge.run.alone import MeasureLock
from judge.run.reference import Reference
from judge.sandbox.boundary import BoxFactory
from judge.sandbox.factory import Containment

Progress = Callable[[int, int], None]  # cases done, cases in all


class Settings(Struct, frozen=True):
    """How to judge, whatever is judged.

    `box_factory` opens the containment; `measured` says whether an accepted submission is raced against the
    reference, and `lock` keeps races alone; `reference` is there where several submissions share it; a
    `program` is run as one even where it defines the problem's function.
    """

    box_factory: BoxFactory = field(default_factory=Containment)
    measured: bool = True
    lock: MeasureLock = field(default_factory=MeasureLock)
    reference: Reference | None = None
    program: bool = False
