"""Draws made of words: a scene is a function from choices to a case.

    lines("touch before after", **BIG)       a circle and a line, turned by any triple
    rays("chord first~", **NEAR)             a ray that begins just off a circle
    pairs("outer", **SPLIT)                  two circles that touch

The words are those of judge.geometry.level and of each scene, the poses those of judge.geometry.pose.
"""

from judge.geometry.level import corners, either, grid, telling, tried, uneven, uniform, whole
from judge.geometry.pose import (
    ASKEW,
    AXIS,
    BIG,
    DECIMALS,
    FAR,
    HUGE,
    LEVEL,
    NEAR,
    OFFSET,
    PLAIN,
    SPLIT,
    STEEP,
    TILTED,
    TINY,
)
from judge.geometry.scenes.crowds import aligned, anywhere, crowd_of, crowds, hardly, solids
from judge.geometry.scenes.doubles import brim, distant
from judge.geometry.scenes.frames import anything, frames
from judge.geometry.scenes.lights import home, lights, shaded, topped
from judge.geometry.scenes.lines import (
    LEANS,
    abreast,
    aimed,
    astray,
    closed_up,
    enlarged,
    faint,
    feet,
    leaning,
    lines,
    merged,
    minute,
    mote,
    neighbours,
    past,
    pinpoint,
    points,
    rays,
    skimming,
    slim,
    slivers,
    sloping,
    speck,
    spheres,
    still,
    terse,
    unsigned,
)
from judge.geometry.scenes.motion import balls, meeting, walls
from judge.geometry.scenes.outlines import aside, cornered, leant, pairs, polygons, polygons_of
from judge.geometry.scenes.ratios import ratios
from judge.geometry.scenes.rows import any_columns, columns, million
