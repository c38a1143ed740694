"""pieces

The ray is cut at the ends of all discs; of every piece its middle is asked for, by the program with true and false.

A disc is one interval of the ray, or none. Ends that are nearly the same are made one first, so that no piece is a
sliver. Then a piece is inside a disc or outside as a whole, and inside the solid if the program says so: `or`, `and`,
`and not` on a stack. Neighbouring pieces that are inside are joined.
"""

from math import hypot, sqrt


def inside_spans(circles, O, D, program):
    (ox, oy), (dx, dy) = O, D
    size = max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    near = 1e-10 * size
    length = hypot(dx, dy)
    ux, uy = dx / length, dy / length

    discs = []
    for x, y, r in circles:
        fx, fy = ox - x, oy - y
        d = abs(ux * fy - uy * fx)
        foot, half = -(fx * ux + fy * uy), sqrt((r - d) * (r + d)) if d < r - near else 0.0
        discs.append((max(0.0, foot - half), max(0.0, foot + half)))

    cuts = []
    for end in sorted({end for disc in discs for end in disc}):
        if not cuts or end - cuts[-1] > near:
            cuts.append(end)

    spans = []
    for start, end in zip(cuts, cuts[1:]):
        middle = (start + end) / 2
        stack = []
        for step in program:
            if step >= 0:
                stack.append(discs[step][0] < middle < discs[step][1])
                continue
            upper, lower = stack.pop(), stack.pop()
            stack.append(lower or upper if step == -1 else lower and upper if step == -2 else lower and not upper)
        if stack.pop():
            if spans and spans[-1][1] == start:
                spans[-1][1] = end
            else:
                spans.append([start, end])
    return [(start / length, end / length) for start, end in spans]
