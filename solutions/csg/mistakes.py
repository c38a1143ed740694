"""How a ray's way through a solid goes wrong: right ways to its spans, and mistakes beside the lines that they spoil."""

from array import array
from math import hypot, sqrt


def single(x):
    return array("f", [x])[0]


def flat(program, inside):
    # the operations in a row, each with the next disc, as if nothing were nested
    numbers = [step for step in program if step >= 0]
    steps = [step for step in program if step < 0]
    held = inside[numbers[0]]
    for number, step in zip(numbers[1:], steps):
        other = inside[number]
        held = held or other if step == -1 else held and other if step == -2 else held and not other
    return held


def pieces(circles, O, D, program):
    "right"
    # + diameter-for-radius: circles = [(x, y, r / 2) for x, y, r in circles]
    # @ `circles` is a list of 1 to 32 discs `(x, y, r)`
    # + diameter-for-radius: circles = [(x, y, 2 * r) for x, y, r in circles]
    # : The radii are doubled, as if they were given halved. They are the radii: use them as they are.
    # + swapped-coordinates: circles = [(y, x, r) for x, y, r in circles]
    # : The discs' x and y are exchanged, those of O and D are not.
    # + single-precision: circles = [tuple(map(single, circle)) for circle in circles]
    (ox, oy), (dx, dy) = O, D
    # ? target-for-direction: (ox, oy), (dx, dy) = O, (D[0] - O[0], D[1] - O[1])
    size = max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    # = size = max(max(r, hypot(x - ox, y - oy)) for x, y, r in circles)
    # ? coordinate-epsilon: size = 1 + max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    # : The threshold does not shrink with the figure: small figures are all epsilon. Measure the
    # : size by the radii and the centres as seen from O, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-8..1e-5/3}
    # ? slivers: near = 0
    # : Nothing is compared with a width. Ends at one place come out a little apart, and a touch is a short chord: make
    # : one of all ends within about 1e-10 of the size, and leave out discs with |d − r| within it.
    # ? loose-epsilon: near = 1e-4 * size
    length = hypot(dx, dy) or 1e-300
    ux, uy = dx / length, dy / length
    # ? direction-not-normalised: ux, uy = dx, dy
    discs = []
    for x, y, r in circles:
        fx, fy = ox - x, oy - y
        # ? forgotten-centre: fx, fy = ox, oy
        # + zero-radius: 1 / r
        # : All lengths are divided by the radius: for r = 0 that is a division by zero. Divide by nothing.
        # + zero-radius: if r == 0: return []
        d = abs(ux * fy - uy * fx)
        # ? global-frame: d = abs((ux * oy - uy * ox) - (ux * y - uy * x))
        foot = -(fx * ux + fy * uy)
        # + centre-behind: if foot < 0: discs.append((0.0, 0.0)); continue
        # ? global-frame: foot = (x * ux + y * uy) - (ox * ux + oy * uy)
        if d >= r - near:
            discs.append((0.0, 0.0))
            continue
        # ? sqrt-of-negative: pass
        half = sqrt((r - d) * (r + d))
        # = half = sqrt(r * r - d * d)
        discs.append((max(0.0, foot - half), max(0.0, foot + half)))
        # ? start-behind: discs.append((foot - half, foot + half))
        # ? start-behind: discs.append((abs(foot - half), abs(foot + half)))
        # : An end behind the origin is counted at |t|, in front of it. The ray begins at t = 0: a start before it
        # : becomes 0, and a disc behind it holds nothing.
        # ? inside-is-miss: discs.append((foot - half, foot + half) if foot - half >= -near else (0.0, 0.0))
        # ? half-chord-only: discs.append((max(0.0, foot), max(0.0, foot + half)))
    cuts = []
    for end in sorted({0.0, *(end for disc in discs for end in disc)}):
        if not cuts or end - cuts[-1] > near:
            cuts.append(end)
    spans = []
    for start, end in zip(cuts, cuts[1:]):
        middle = (start + end) / 2
        inside = [first < middle < last for first, last in discs]
        stack = []
        for step in program:
            if step >= 0:
                stack.append(inside[step])
                continue
            upper, lower = stack.pop(), stack.pop()
            # ? difference-swapped: lower, upper = stack.pop(), stack.pop()
            # @ the lower one less the upper one
            stack.append(lower or upper if step == -1 else lower and upper if step == -2 else lower and not upper)
            # ? operations-swapped: stack.append(lower and upper if step == -1 else lower or upper if step == -2 else lower and not upper)
            # @ pushes their union
            # ? even-odd: stack.append(lower != upper if step == -1 else lower and upper if step == -2 else lower and not upper)
            # @ pushes their union
            # ? either-for-difference: stack.append(lower or upper if step == -1 else lower and upper if step == -2 else lower != upper)
        # + counter-only: stack = [any(inside[step] for step in program if step >= 0)]
        # + left-to-right: stack = [flat(program, inside)]
        # @ in postfix notation
        # + first-disc-only: stack = [inside[program[0]]]
        # @ pushes the disc n
        if stack[0]:
            if spans and spans[-1][1] == start:
                spans[-1][1] = end
            else:
                spans.append([start, end])
            # ? not-merged: spans.append([start, end])
            # @ as long as possible
            # : Every piece between two ends is a span of its own. Join those that follow one another.
    # + hull: spans = [[spans[0][0], spans[-1][1]]] if spans else []
    # + segment-for-ray: spans = [(start, min(end, length)) for start, end in spans if start < length]
    # + first-span-only: spans = spans[:1]
    # @ Return a list
    return [(start / length, end / length) for start, end in spans]
    # ? distance-for-parameter: return [(start, end) for start, end in spans]
    # @ t is the parameter
    # ? direction-not-normalised: return [(start / length / length, end / length / length) for start, end in spans]
    # ? rounded-output: return [(round(start / length, 6), round(end / length, 6)) for start, end in spans]


def lists(circles, O, D, program):
    "right"
    near = 1e-10 * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    size = hypot(*D) or 1e-300
    stack = []
    for step in program:
        if step >= 0:
            x, y, r = circles[step]
            fx, fy = O[0] - x, O[1] - y
            d = abs(D[0] * fy - D[1] * fx) / size
            half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
            # ? sqrt-of-negative: half = sqrt((r - d) * (r + d))
            # ? touch-is-span: half = sqrt(max(0.0, (r - d) * (r + d)))
            middle = -(fx * D[0] + fy * D[1]) / size
            stack.append([(max(0.0, middle - half), middle + half)] if half and middle + half > near else [])
            # ? touch-is-point: stack.append([(max(0.0, middle - half), middle + half)] if d <= r + near and middle + half > near else [])
            # @ adds nothing to the solid
            continue
        upper, lower = stack.pop(), stack.pop()
        if step == -1:
            found = []
            for start, end in sorted(lower + upper):
                if found and start <= found[-1][1] + near:
                    found[-1] = found[-1][0], max(found[-1][1], end)
                    # ? enclosed-cuts: found[-1] = found[-1][0], end
                    # ? not-merged: found.append((start, end))
                else:
                    found.append((start, end))
        elif step == -2:
            found = [(max(p[0], q[0]), min(p[1], q[1])) for p in lower for q in upper]
            found = sorted((start, end) for start, end in found if end - start > near)
            # ? empty-interval: found = sorted(found)
            # @ pushes their intersection
            # ? slivers: found = sorted((start, end) for start, end in found if end > start)
        else:
            found = lower
            # ? first-hole-only: upper = [next((q for q in upper if q[0] < e and q[1] > s), (0, 0)) for s, e in found]
            for first, last in upper:
                left = [(start, min(end, first)) for start, end in found]
                right = [(max(start, last), end) for start, end in found]
                # ? hole-lost: right = [(max(start, last), end) for start, end in found if start >= first]
                # : Of a disc with a hole in the middle only the part before the hole is left. Both are.
                # ? hole-lost: left, right = (left, right) if not any(s < first and last < e for s, e in found) else (found, [])
                # : A hole in the middle is not cut out: the difference looks at overlaps at an end only. It leaves two
                # : parts.
                found = sorted((start, end) for start, end in left + right if end - start > near)
                # ? slivers: found = sorted((start, end) for start, end in left + right if end > start)
        stack.append(found)
    return [(start / size, end / size) for start, end in stack.pop()]


def textbook(circles, O, D, program):
    """absolute-epsilon

    For example, lengths and parameters are compared with a fixed number. Measure all of them by the size, as
    lengths.
    """
    eps = 1e-9
    # = eps = 1e-12
    # = eps = 1e-10
    # = eps = 1e-8
    # = eps = 1e-6
    a = D[0] * D[0] + D[1] * D[1]
    discs = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        b = fx * D[0] + fy * D[1]
        disc = b * b - a * (fx * fx + fy * fy - r * r)
        # = disc = r * r * a - (D[0] * fy - D[1] * fx) ** 2
        root = sqrt(disc) if disc > eps else 0.0
        discs.append((max(0.0, (-b - root) / a), max(0.0, (-b + root) / a)))
    ends = sorted({0.0, *(end for disc in discs for end in disc)})
    spans = []
    for start, end in zip(ends, ends[1:]):
        if end - start <= eps:
            continue
        inside = [first < (start + end) / 2 < last for first, last in discs]
        stack = []
        for step in program:
            if step >= 0:
                stack.append(inside[step])
            else:
                upper = stack.pop()
                lower = stack.pop()
                stack.append(lower or upper if step == -1 else lower and upper if step == -2 else lower and not upper)
        if stack[0]:
            if spans and start - spans[-1][1] <= eps:
                spans[-1] = spans[-1][0], end
            else:
                spans.append((start, end))
    return spans


def slope(circles, O, D, program):
    "slope-intercept"
    near = 1e-10 * max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    m = D[1] / D[0]
    # = m = D[1] / D[0] if D[0] else 0.0
    # = m = D[1] / (D[0] or 1e-9)
    discs = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        n = fy - m * fx
        d = abs(n) / sqrt(1 + m * m)
        half = sqrt((r - d) * (r + d)) / sqrt(1 + m * m) if d < r - near else 0.0
        middle = -m * n / (1 + m * m)
        ts = sorted([(middle - half - fx) / (D[0] or 1e-9), (middle + half - fx) / (D[0] or 1e-9)])
        discs.append((max(0.0, ts[0]), max(0.0, ts[1])) if half else (0.0, 0.0))
    cuts = []
    for end in sorted({0.0, *(end for disc in discs for end in disc)}):
        if not cuts or (end - cuts[-1]) * hypot(*D) > near:
            cuts.append(end)
    spans = []
    for start, end in zip(cuts, cuts[1:]):
        inside = [first < (start + end) / 2 < last for first, last in discs]
        stack = []
        for step in program:
            if step >= 0:
                stack.append(inside[step])
            else:
                upper, lower = stack.pop(), stack.pop()
                stack.append(lower or upper if step == -1 else lower and upper if step == -2 else lower and not upper)
        if stack[0]:
            spans = [*spans[:-1], (spans[-1][0], end)] if spans and spans[-1][1] == start else [*spans, (start, end)]
    return spans
