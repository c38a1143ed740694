"""squares

|f|² against r²: an area, so the threshold is one, 2e times as wide as that of a length. No root is taken.
"""


def on_circle(cx, cy, r, P):
    fx, fy = P[0] - cx, P[1] - cy
    size = max(r, abs(fx), abs(fy))
    area = fx * fx + fy * fy - r * r
    if abs(area) <= 2e-10 * size * size:
        return 0
    return 1 if area > 0 else -1
