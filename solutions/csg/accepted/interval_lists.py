"""interval lists

Three rules for sorted lists of intervals, by merging; all of them follow from union and complement.
"""

from math import inf, sqrt


def union(one, other):
    """Two lists of intervals as one; what overlaps is joined."""
    joined = []
    for start, end in sorted(one + other):
        if joined and start <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(end, joined[-1][1]))
        else:
            joined.append((start, end))
    return joined


def complement(spans, near):
    """What is left of all of the line; gaps of no length are none, so what nearly meets is joined."""
    ends = [-inf, *(end for span in spans for end in span), inf]
    gaps = zip(ends[::2], ends[1::2])
    return [(start, end) for start, end in gaps if end - start > near]


def intersection(one, other, near):
    return complement(union(complement(one, near), complement(other, near)), near)


def inside_spans(circles, O, D, program):
    near = 1e-10 * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    a = D[0] * D[0] + D[1] * D[1]
    size = sqrt(a)
    solids = []
    for step in program:
        if step >= 0:
            x, y, r = circles[step]
            fx, fy = O[0] - x, O[1] - y
            side = abs(fy * D[0] - fx * D[1]) / size
            middle = -(fx * D[0] + fy * D[1]) / size
            half = sqrt((r - side) * (r + side)) if r - side > near else 0
            solids.append([(middle - half, middle + half)] if half else [])
            continue
        upper, lower = solids.pop(), solids.pop()
        if step == -1:
            solids.append(union(lower, upper))
        elif step == -2:
            solids.append(intersection(lower, upper, near))
        else:
            solids.append(intersection(lower, complement(upper, near), near))
    ahead = intersection(solids.pop(), [(0.0, inf)], near)
    return [(start / size, end / size) for start, end in ahead]
