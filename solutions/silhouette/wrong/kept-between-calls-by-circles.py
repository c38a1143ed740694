"""kept-between-calls

Distances are kept in a dict whose key is the circle alone, so that another line gets those of the first one. Make all
arguments the key, or keep nothing.
"""

from math import hypot

distances = {}


def steady_hits(circles, O, D, h):
    answer = []
    for circle in circles:
        x, y, r = circle
        fx, fy = O[0] - x, O[1] - y
        if (x, y) not in distances:
            distances[x, y] = abs(D[0] * fy - D[1] * fx) / hypot(*D)
        d, near = distances[x, y], 1e-10 * max(r, abs(fx), abs(fy))
        if not answer:
            answer.append(int(d < r))
        else:
            answer.append(int(d <= r * (1 + h) + near if answer[-1] else d < r * (1 - h) - near))
    return answer
