"""the last word

Each frame by itself says in, out, or nothing, by complex numbers: the line is turned level, and the height of the
circle's centre above it is compared with both thresholds. What is shown is the last word that was said.
"""

from itertools import accumulate


def steady_hits(circles, O, D, h):
    start, way = complex(*O), complex(*D)
    way /= abs(way)

    def word(circle):
        x, y, r = circle
        away = complex(x, y) - start
        d, width = abs((away / way).imag), 1e-10 * max(r, abs(away))
        if d < r * (1 - h) - width:
            return 1
        return 0 if d > r * (1 + h) + width else None

    x, y, r = circles[0]
    first = 1 if abs(((complex(x, y) - start) / way).imag) < r else 0
    said = [first, *map(word, circles[1:])]
    return list(accumulate(said, lambda last, new: last if new is None else new))
