"""kept-between-calls

The discs' intervals are kept for each list of discs, and a later call with another ray is given those of the first.
What is kept needs a key of all that it was made of; or keep nothing.
"""

from math import hypot, sqrt

known = {}


def inside_spans(circles, O, D, program):
    near = 1e-10 * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    size = hypot(*D)
    discs = known.setdefault(tuple(circles), [])
    if not discs:
        for x, y, r in circles:
            fx, fy = O[0] - x, O[1] - y
            d = abs(D[0] * fy - D[1] * fx) / size
            half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
            middle = -(fx * D[0] + fy * D[1]) / size
            discs.append((max(0.0, middle - half), max(0.0, middle + half)) if half else (0.0, 0.0))
    cuts = []
    for end in sorted({0.0, *(end for disc in discs for end in disc)}):
        if not cuts or end - cuts[-1] > near:
            cuts.append(end)
    spans = []
    for start, end in zip(cuts, cuts[1:]):
        stack = []
        for step in program:
            if step >= 0:
                stack.append(discs[step][0] < (start + end) / 2 < discs[step][1])
                continue
            upper, lower = stack.pop(), stack.pop()
            stack.append((lower or upper, lower and upper, lower and not upper)[-1 - step])
        if stack[0]:
            if spans and spans[-1][1] == start:
                spans[-1][1] = end
            else:
                spans.append([start, end])
    return [(start / size, end / size) for start, end in spans]
