"""far off the surface

The second ray starts as far off the surface as may be: 5e-8 of the size along its way.
"""

from math import hypot, sqrt


def roots(circle, start, unit):
    x, y, r = circle
    fx, fy = start[0] - x, start[1] - y
    d, foot = abs(unit[0] * fy - unit[1] * fx), -(fx * unit[0] + fy * unit[1])
    half = sqrt((r - d) * (r + d)) if d < r else None
    return () if half is None else (foot - half, foot + half)


def light(circles, O, D, L):
    seen = [(x - O[0], y - O[1], r) for x, y, r in circles]
    lamp = L[0] - O[0], L[1] - O[1]
    size = max(*map(abs, lamp), *(max(abs(x), abs(y), r) for x, y, r in seen))
    length = hypot(*D)
    unit = D[0] / length, D[1] / length
    hits = [(way, circle) for circle in seen for way in roots(circle, (0.0, 0.0), unit) if way > 0]
    if not hits:
        return None
    way, (x, y, r) = min(hits)
    point = way * unit[0], way * unit[1]
    normal = point[0] - x, point[1] - y
    towards = lamp[0] - point[0], lamp[1] - point[1]
    before = unit[0] * normal[0] + unit[1] * normal[1] < 0
    if before != (towards[0] * normal[0] + towards[1] * normal[1] > 0):
        return "dark"
    reach = hypot(*towards)
    second = towards[0] / reach, towards[1] / reach
    walls = (way for circle in seen for way in roots(circle, point, second))
    return "dark" if any(5e-8 * size < way < reach for way in walls) else "lit"
