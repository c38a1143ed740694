"""height-of-the-circle

Above x the circle is as high as the root of r² - dx² = (r - dx)(r + dx), which is held against dy. Where dx is more than
r there is no circle above x: that product is below 0, and P outside.
"""


def circle_side(cx, cy, r, P):
    dx, dy = P[0] - cx, P[1] - cy
    room = (r - dx) * (r + dx)
    return (dy * dy > room) - (dy * dy < room)
