"""the widest tolerance

A sweep over the ends in order: those within 1e-8 of the size of the first one are one place, and so is the origin.
"""

from math import hypot, sqrt


def solid(program, held):
    stack = []
    for step in program:
        if step >= 0:
            stack.append(held[step])
        else:
            upper, lower = stack.pop(), stack.pop()
            stack.append((lower or upper, lower and upper, lower and not upper)[-step - 1])
    return stack[0]


def inside_spans(circles, O, D, program):
    size = max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    near, length = 1e-8 * size, hypot(*D)
    ends = [(0.0, 0, None)]
    for index, (x, y, r) in enumerate(circles):
        fx, fy = O[0] - x, O[1] - y
        d = abs(D[0] * fy - D[1] * fx) / length
        foot = -(fx * D[0] + fy * D[1]) / length
        half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
        if half and foot + half > near:
            ends += [(max(0.0, foot - half), index, True), (foot + half, index, False)]
    ends.sort(key=lambda end: end[0])
    held, spans, start, at = [False] * len(circles), [], None, 0
    while at < len(ends):
        way = ends[at][0]
        while at < len(ends) and ends[at][0] - way <= near:
            if ends[at][2] is not None:
                held[ends[at][1]] = ends[at][2]
            at += 1
        if solid(program, held):
            start = way if start is None else start
        elif start is not None:
            spans.append((start / length, way / length))
            start = None
    return spans
