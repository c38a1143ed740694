"""global-frame

c is expanded into x² + y² - 2(x·cx + y·cy) + cx² + cy² - r², and far from the origin nothing is left of it.
Subtract C from A and B first, and compute with the differences.
"""

from math import sqrt


def circle_segment(cx, cy, r, A, B):
    x1, y1 = A
    x2, y2 = B
    dx, dy = x2 - x1, y2 - y1
    near = 1e-10 * max(r, abs(x1 - cx), abs(y1 - cy), abs(x2 - cx), abs(y2 - cy))
    a = dx * dx + dy * dy
    c = x1 * x1 + y1 * y1 - 2 * (x1 * cx + y1 * cy) + cx * cx + cy * cy - r * r
    if a == 0:
        return [A] if abs(c) <= near * (2 * r + near) else []
    b = (x1 * dx + y1 * dy) - (cx * dx + cy * dy)
    disc = b * b - a * c
    limit = 2 * r * near * a
    if disc < -limit:
        return []
    ts = [-b / a] if disc <= limit else [(-b - sqrt(disc)) / a, (-b + sqrt(disc)) / a]
    slack = near / sqrt(a)
    return [(x1 + t * dx, y1 + t * dy) for t in ts if -slack <= t <= 1 + slack]
