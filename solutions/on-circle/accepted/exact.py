"""fractions

A float is a fraction, so |P − C|² and r² are fractions too, and nothing needs to be rounded.
"""

from fractions import Fraction


def on_circle(cx, cy, r, P):
    cx, cy, r, px, py = map(Fraction, (cx, cy, r, *P))
    gap = (px - cx) ** 2 + (py - cy) ** 2 - r * r
    return (gap > 0) - (gap < 0)
