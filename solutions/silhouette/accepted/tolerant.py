"""tolerant

Floats, and 1e-9 of each frame's size.
"""

from math import hypot


def steady_hits(circles, O, D, h):
    length = hypot(*D)
    answer = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        d, near = abs(D[0] * fy - D[1] * fx) / length, 1e-9 * max(r, abs(fx), abs(fy))
        if not answer:
            answer.append(int(d < r))
        elif answer[-1]:
            answer.append(int(d <= r * (1 + h) + near))
        else:
            answer.append(int(d < r * (1 - h) - near))
    return answer
