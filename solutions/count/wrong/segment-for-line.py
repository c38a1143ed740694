"""segment-for-line

Only the points between A and B are counted. The question is about the infinite line: drop the test
of the parameter.
"""

import math


def line_count(cx, cy, r, A, B):
    fx, fy = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    length = math.hypot(dx, dy)
    if length == 0:
        return None
    ux, uy = dx / length, dy / length
    foot = -(fx * ux + fy * uy)
    d = abs(ux * fy - uy * fx)
    slack = 1e-10 * max(r, abs(fx), abs(fy), abs(fx + dx), abs(fy + dy))
    if d > r + slack:
        return 0
    if d >= r - slack:
        places = [foot]
    else:
        half = math.sqrt((r - d) * (r + d))
        places = [foot - half, foot + half]
    return sum(1 for s in places if -slack <= s <= length + slack)
