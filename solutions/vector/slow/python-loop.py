"""python-loop

Every circle is taken out of the arrays by itself, and the interpreter does a dozen steps for each. Let one operation do
all circles at once.
"""

from math import hypot


def count_many(cx, cy, r, A, B):
    (ax, ay), (bx, by) = A, B
    dx, dy = bx - ax, by - ay
    length = hypot(dx, dy)
    answer = []
    for x, y, radius in zip(cx, cy, r):
        fx, fy = ax - x, ay - y
        gap = abs(dx * fy - dy * fx) / length - radius
        near = 1e-10 * max(radius, abs(fx), abs(fy), abs(bx - x), abs(by - y))
        answer.append(0 if gap > near else 2 if gap < -near else 1)
    return answer
