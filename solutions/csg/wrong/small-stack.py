"""small-stack

The stack holds sixteen solids and forgets the lowest ones. A program may put all of 32 discs there: let it grow.
"""

from collections import deque
from math import hypot, sqrt


def inside_spans(circles, O, D, program):
    ox, oy = O
    n = hypot(*D)
    ux, uy = D[0] / n, D[1] / n
    e = max(max(abs(x - ox), abs(y - oy), r) for x, y, r in circles)
    eps = 1e-10 * e
    spans = []
    for x, y, r in circles:
        gx, gy = x - ox, y - oy
        d = abs(ux * gy - uy * gx)
        if d >= r - eps:
            spans.append([])
            continue
        s = gx * ux + gy * uy
        h = sqrt((r - d) * (r + d))
        low, high = max(0.0, s - h), s + h
        spans.append([(low, high)] if high > eps else [])
    stack = deque(maxlen=16)
    for step in program:
        if step >= 0:
            stack.append(spans[step])
            continue
        b = stack.pop()
        a = stack.pop() if stack else []
        rule = (join, meet, less)[-1 - step]
        stack.append(rule(a, b, eps))
    return [(low / n, high / n) for low, high in stack.pop()]


def join(a, b, eps):
    out = []
    for low, high in sorted(a + b):
        if out and low <= out[-1][1] + eps:
            out[-1] = (out[-1][0], max(high, out[-1][1]))
        else:
            out.append((low, high))
    return out


def meet(a, b, eps):
    out = []
    for p, q in a:
        for v, w in b:
            low, high = max(p, v), min(q, w)
            if high - low > eps:
                out.append((low, high))
    return out


def less(a, b, eps):
    out = []
    for p, q in a:
        for v, w in b:
            if w <= p + eps or v >= q - eps:
                continue
            if v - p > eps:
                out.append((p, v))
            p = w
        if q - p > eps:
            out.append((p, q))
    return out
