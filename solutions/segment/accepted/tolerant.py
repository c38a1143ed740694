"""foot and half-chord, with a tolerance

The foot of the perpendicular and the half-chord, in the circle's own frame.
"""

from math import hypot, sqrt


def circle_segment(cx, cy, r, A, B):
    ax, ay = A[0] - cx, A[1] - cy
    dx, dy = B[0] - A[0], B[1] - A[1]
    size = max(r, abs(ax), abs(ay), abs(B[0] - cx), abs(B[1] - cy))
    near = 1e-9 * size

    length = hypot(dx, dy)
    if length == 0:
        return [A] if abs(hypot(ax, ay) - r) <= near else []

    ux, uy = dx / length, dy / length
    offset = ux * ay - uy * ax  # of the line from the centre, along the left normal (-uy, ux)
    to_foot = -(ux * ax + uy * ay)
    foot_x, foot_y = cx - offset * uy, cy + offset * ux

    distance = abs(offset)
    if distance > r + near:
        return []
    if distance >= r - near:
        steps = [0.0]
    else:
        half_chord = sqrt((r - distance) * (r + distance))
        steps = [-half_chord, half_chord]
    return [
        (foot_x + step * ux, foot_y + step * uy)
        for step in steps
        if -near <= to_foot + step <= length + near
    ]
