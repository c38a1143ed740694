"""angles

The radius to the point makes an angle with C1→C2 whose cosine is (r1 − r2)/d, or (r1 + r2)/d.

The angle is found by its half, so that no digits are lost where the cosine is nearly 1.
"""

from math import atan2, cos, hypot, pi, sin, sqrt


def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    d = hypot(cx2 - cx1, cy2 - cy1)
    slack = 1e-9 * max(r1, r2, d)
    heading = atan2(cy2 - cy1, cx2 - cx1)
    turns = []
    for reach in (r1 - r2, r1 + r2):
        if abs(d - abs(reach)) <= slack:
            turns.append(0 if reach > 0 else pi)
        elif d > abs(reach):
            angle = 2 * atan2(sqrt(d - reach), sqrt(d + reach))
            turns += [angle, -angle]
    return [[cx1 + r1 * cos(heading + turn), cy1 + r1 * sin(heading + turn)] for turn in turns]
