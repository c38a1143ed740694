"""What a drawing is made of: panels of strokes, marks and bars in floats near 1, and the words beside them.

A panel is the square −1 … 1 in both directions, y upwards. Everything that is drawn lies within it.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

Dot = tuple[float, float]


class Role(Enum):
    """What a thing is, not how it looks."""

    SHAPE = "shape"  # a closed figure
    LINE = "line"
    BEYOND = "beyond"  # where the line goes on beyond its ends
    CASE = "case"  # a point of the input
    WANTED = "wanted"
    GOT = "got"

    @property
    def said(self) -> str:
        """What an answer of that role is called."""
        return "expected" if self is Role.WANTED else self.value


@dataclass(frozen=True, slots=True)
class Stroke:
    """A polyline; `arrow` puts a head on its last piece. With `filled` it is an area without a border."""

    dots: tuple[Dot, ...]
    role: Role
    arrow: bool = False
    filled: bool = False


@dataclass(frozen=True, slots=True)
class Mark:
    """A point and its name, `shared` with points of other roles where it stands for all that meet there.

    Where it stands at the edge for one that lies outside, that is `towards` there and so far `away`. `sign`
    is the letter or two that it has in a terminal.
    """

    at: Dot
    role: Role
    text: str
    sign: str = ""
    towards: Dot | None = None
    away: str = ""
    shared: bool = False

    @property
    def label(self) -> str:
        """Its name, and how far away it is."""
        return f"{self.text}, {self.away} away" if self.away else self.text


@dataclass(frozen=True, slots=True)
class Word:
    """A text in the middle of a place, which has so much `room` from left to right."""

    at: Dot
    role: Role
    text: str
    room: float


@dataclass(frozen=True, slots=True)
class Bar:
    """A scale bar: its length in the panel and what that is; upright where it measures across the line."""

    length: float
    text: str
    upright: bool = False


@dataclass(frozen=True, slots=True)
class Panel:
    """One square drawing with its heading."""

    title: str
    strokes: tuple[Stroke, ...]
    marks: tuple[Mark, ...]
    bars: tuple[Bar, ...]
    note: str = ""
    words: tuple[Word, ...] = ()


@dataclass(frozen=True, slots=True)
class Picture:
    """A case and its answers: the whole at true scale, the place that matters enlarged, and in words."""

    description: str
    whole: Panel
    lens: Panel | None
    why: str = ""  # what the case turns on, where that is exact or cannot be seen
    keys: tuple[str, str] = (Role.WANTED.said, Role.GOT.said)  # what the two kinds of marks are called
    scaled: bool = True  # whether lengths are those of the case

    @property
    def panels(self) -> tuple[Panel, ...]:
        """The panels, left to right."""
        return (self.whole,) if self.lens is None else (self.whole, self.lens)
