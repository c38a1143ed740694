"""height-of-the-circle

Above x the circle is as high as the root of r² - dx² = (r - dx)(r + dx), which is held against dy. Where dx is more than
r there is no circle above x, and P is outside.
"""


def circle_side(cx, cy, r, P):
    dx, dy = abs(P[0] - cx), abs(P[1] - cy)
    if dx > r:
        return 1
    room = (r - dx) * (r + dx)
    return (dy * dy > room) - (dy * dy < room)
