"""squares

P is as far from C as the root of dx² + dy². That is compared with r, and so are the squares: dx² + dy² with r².

Why it is exact: there are only differences and products of whole numbers. Two numbers that are not negative
compare as their squares do.
"""


def circle_side(cx, cy, r, P):
    dx, dy = P[0] - cx, P[1] - cy
    square = dx * dx + dy * dy
    if square < r * r:
        return -1
    if square > r * r:
        return 1
    return 0
