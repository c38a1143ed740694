"""kept-between-calls

The thresholds of a radius are kept in a dict, without the h that they were made with. Make all arguments the key, or
keep nothing.
"""

from math import hypot

thresholds = {}


def steady_hits(circles, O, D, h):
    answer = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        d = abs(D[0] * fy - D[1] * fx) / hypot(*D)
        low, high = thresholds.setdefault(r, (r * (1 - h), r * (1 + h)))
        near = 1e-10 * max(r, abs(fx), abs(fy))
        if not answer:
            answer.append(int(d < r))
        else:
            answer.append(int(d <= high + near if answer[-1] else d < low - near))
    return answer
