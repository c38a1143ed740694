"""quadratic-about-the-foot

The quadratic equation for the parameter t, but with its origin slid to the foot of the
perpendicular first. There the linear term vanishes, and what remains, a·t² = (r - d)(r + d), loses
no digits.

Why that matters: in b² - a·c both terms are as large as the figure, and what decides may be as
small as the circle. Their difference keeps the rounding errors of the large ones. Seen from the
foot there is only d and r, two lengths, and r - d is exact where they are close to each other.

The threshold is one for (r - d)(r + d), not for r - d: so it is 1e-10 of the figure's size times
r + d, far above the rounding and far below the first real miss.
A == B is asked for first and exactly, since close points do give a line.
"""

import math


def line_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    px, py = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    a = dx * dx + dy * dy
    # Two steps: the second one removes what the first has lost when A is far away.
    for _ in range(2):
        t = -(px * dx + py * dy) / a
        px, py = px + t * dx, py + t * dy
    d = math.hypot(px, py)
    largest = max(r, *(abs(p[i] - c) for p in (A, B) for i, c in enumerate((cx, cy))))
    room = 1e-10 * largest * (r + d)
    right_side = (r - d) * (r + d)  # of a·t² = …
    if -room <= right_side <= room:
        return 1
    return 2 if right_side > 0 else 0
