"""always-exact

Every line is decided in integers, also those that a double decides. That is right, and takes some ten times
as long as a filter. Compare |Δ| with a bound of its roundings first.
"""


def delta_sign(*numbers):
    ratios = [x.as_integer_ratio() for x in numbers]
    unit = max([bottom for _, bottom in ratios])
    cx, cy, r, ax, ay, bx, by = [top * (unit // bottom) for top, bottom in ratios]
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return (delta > 0) - (delta < 0)
