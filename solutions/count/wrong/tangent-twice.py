"""tangent-twice

The two roots of a tangency are the same point and are counted as two. Ask for the tangency first,
and answer 1.
"""

import math


def line_count(cx, cy, r, A, B):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    px, py, qx, qy = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    extent = max(map(abs, (r, px, py, qx, qy)))
    d = abs(px * (B[1] - A[1]) - py * (B[0] - A[0])) / math.dist(A, B)
    half_chord = 0.0
    if d > r + 1e-10 * extent:
        return 0
    if d < r:
        half_chord = math.sqrt((r - d) * (r + d))
    roots = [-half_chord, half_chord]
    return len(roots)
