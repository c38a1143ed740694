"""sweep

Walk along the ray from end to end: each one switches a disc on or off, and after all at one place the solid is asked.
"""

from math import sqrt


def holds(program, on):
    stack = []
    for step in program:
        if step >= 0:
            stack.append(step in on)
        else:
            upper, lower = stack.pop(), stack.pop()
            stack.append((lower | upper, lower & upper, lower & (not upper))[-1 - step])
    return stack.pop()


def inside_spans(circles, O, D, program):
    e = max(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles)
    step = max(abs(D[0]), abs(D[1]))
    vx, vy = D[0] / step, D[1] / step
    n = vx * vx + vy * vy
    near = 1e-10 * e
    on, events = set(), []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = x - O[0], y - O[1]
        d = abs(vx * fy - vy * fx) / sqrt(n)
        if d + near >= r:
            continue
        half = sqrt((r - d) * (r + d) / n)
        middle = (fx * vx + fy * vy) / n
        if middle + half <= near:
            continue
        if middle - half <= near:
            on.add(index)
        else:
            events.append((middle - half, index))
        events.append((middle + half, index))
    events.sort()
    spans, start = [], 0.0 if holds(program, on) else None
    at = 0
    while at < len(events):
        place = events[at][0]
        while at < len(events) and events[at][0] - place <= near:
            on ^= {events[at][1]}
            at += 1
        inside = holds(program, on)
        if inside and start is None:
            start = place
        elif not inside and start is not None:
            spans.append((start / step, place / step))
            start = None
    return spans
