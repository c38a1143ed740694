"""Exact figures of circles, lines and points: all that the judge knows of geometry.

Line         a circle with a line, a segment, a ray or a point
Sphere       a sphere and a ray
Pair, Lie    two circles, and how they lie
Crowd        many circles and one ray
Quadratic    a line or a motion past a circle or sphere, which the others are made of
Sure         decisions that are exact or clear, else InvalidCase
whole        signs, counts and roots of numbers just as they are, without any promise

    def solve(cx, cy, r, A, B):
        line = Line.through(cx, cy, r, A, B)
        return [line.real_point(which) for which in line.within()]
"""

from judge.geometry import whole
from judge.geometry.crowd import Crowd
from judge.geometry.line import Line
from judge.geometry.pair import Lie, Pair
from judge.geometry.quadratic import Quadratic, Sphere
from judge.geometry.sure import DecisionWords, Root, Sure

__all__ = ["Crowd", "DecisionWords", "Lie", "Line", "Pair", "Quadratic", "Root", "Sphere", "Sure", "whole"]
