"""state machine

One bit is remembered from frame to frame: whether a hit was shown last. It says which of the two
thresholds counts now.

The distance of the centre from the line is the cross product of the line's direction and O − C, by the
direction's length: the foot may be anywhere, for the line has no ends. After a hit only r·(1 + h) counts,
and after a miss only r·(1 − h). The first frame remembers nothing, and compares d with r itself.

A threshold is passed only by more than 1e-10 of the frame's size, so that rounding never passes one.
"""

from math import hypot


def steady_hits(circles, O, D, h):
    length = hypot(D[0], D[1])
    ux, uy = D[0] / length, D[1] / length
    shown, answer = None, []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        d = abs(ux * fy - uy * fx)
        near = 1e-10 * max(r, abs(fx), abs(fy))
        if shown is None:
            shown = d < r
        elif shown:
            shown = d <= r * (1 + h) + near
        else:
            shown = d < r * (1 - h) - near
        answer.append(int(shown))
    return answer
