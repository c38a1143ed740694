"""law of cosines

The triangle of C1, C2 and a common point has the sides r1, r2 and d: its angle at C1, to the left and to the right.

The angle comes from its half, so that nothing is lost where the triangle is nearly flat.
"""

from math import atan2, cos, hypot, sin, sqrt


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    dx, dy = cx2 - cx1, cy2 - cy1
    distance = hypot(dx, dy)
    slack = 1e-9 * max(r1, r2, distance)
    if distance <= slack:
        if max(r1, r2) == 0:
            return [[cx1, cy1]]
        return [] if abs(r1 - r2) > slack else None

    # by the half-angle: tan² = (s − r1)(s − d) / (s(s − r2)), 2s being the sum of the three sides
    left_over = r1 + r2 - distance  # 2(s − d)
    first = distance + r2 - r1  # 2(s − r1)
    second = distance + r1 - r2  # 2(s − r2)
    if min(left_over, first, second) < -slack:
        return []
    heading = atan2(dy, dx)
    if abs(left_over) <= slack or abs(second) <= slack or abs(first) <= slack:
        towards = -1 if abs(left_over) > slack and r1 < r2 else 1
        return [[cx1 + towards * r1 * cos(heading), cy1 + towards * r1 * sin(heading)]]
    angle = 2 * atan2(sqrt(first * left_over), sqrt((r1 + r2 + distance) * second))
    return [[cx1 + r1 * cos(heading + t), cy1 + r1 * sin(heading + t)] for t in (angle, -angle)]
