"""How the distance squared goes wrong: right ways to it, and mistakes beside the lines that they spoil."""

from math import dist, isqrt, sqrt


def wrap(x):
    return (x + (1 << 31)) % (1 << 32) - (1 << 31)


def legs(P, Q):
    "right"
    # + sum-for-difference: Q = (-Q[0], -Q[1])
    # : The coordinates are added where they have to be subtracted. The way along x is Q's x less P's x.
    dx = Q[0] - P[0]
    # = dx = abs(P[0] - Q[0])
    # ? swapped-coordinates: dx = Q[0] - P[1]
    # ? swapped-coordinates: dx = P[1] - P[0]
    # : The difference is that of P's own coordinates. Take the x of Q less the x of P.
    # ? sum-for-difference: dx = abs(Q[0]) - abs(P[0])
    # : abs is taken of each coordinate before they are subtracted, and -3 and 3 come out as one place. Subtract first;
    # : the square needs no abs.
    dy = Q[1] - P[1]
    # = dy = abs(P[1] - Q[1])
    return dx * dx + dy * dy
    # = return dx**2 + dy**2
    # ? steps-for-distance: return abs(dx) + abs(dy)
    # ? steps-for-distance: return max(abs(dx), abs(dy)) ** 2
    # : Only the longer one of the two ways is squared. The straight way needs both: square both and add.
    # ? forgotten-square: return dx + dy
    # ? caret-for-power: return (dx ^ 2) + (dy ^ 2)
    # ? doubled-for-squared: return 2 * dx + 2 * dy
    # ? minus-for-plus: return dx * dx - dy * dy
    # ? square-of-the-sum: return (dx + dy) ** 2
    # ? product-of-squares: return dx * dx * dy * dy
    # ? one-coordinate: return dx * dx
    # ? one-coordinate: return dx * dy
    # : dx and dy are multiplied with each other, which is the area of a rectangle. Multiply each with itself, and add.
    # ? root-returned: return sqrt(dx * dx + dy * dy)
    # @ no root to take
    # ? root-returned: return isqrt(dx * dx + dy * dy)
    # : The root is taken in the end, and made a whole number. The distance squared is asked for: leave the root out.
    # ? root-squared: return int(sqrt(dx * dx + dy * dy) ** 2)
    # ? root-squared: return isqrt(dx * dx + dy * dy) ** 2
    # : isqrt rounds down to a whole number, and squaring does not bring back what was lost. The sum of the squares is the
    # : answer already.
    # ? float-arithmetic: return round(dist(P, Q) ** 2)
    # ? float-arithmetic: return int(float(dx) ** 2 + float(dy) ** 2)
    # : The squares are computed as floats, which hold about 16 digits. Whole numbers have no such end: leave out float().
    # ? overflow-32: return wrap(dx * dx + dy * dy)
    # @ of whole numbers
    # ? overflow-32: return (dx * dx + dy * dy) % (1 << 32)
    # ? float-answer: return dist(P, Q) ** 2
    # ? forgotten-brackets: return P[0] - Q[0] ** 2 + P[1] - Q[1] ** 2
    # ? forgotten-brackets: return abs(Q[0] ** 2 - P[0] ** 2) + abs(Q[1] ** 2 - P[1] ** 2)
    # : The coordinates are squared before they are subtracted. Subtract first: (a - b)² is not a² - b².


def back(P, Q):
    "right"
    dx, dy = P[0] - Q[0], P[1] - Q[1]
    # ? swapped-coordinates: dx, dy = P[0] - P[1], Q[0] - Q[1]
    # : The differences are those of the coordinates of one point. Take the x of one point less the x of the other.
    # ? swapped-coordinates: dx, dy = P[0] - Q[1], P[1] - Q[0]
    return dx**2 + dy**2
    # ? caret-for-power: return (dx ^ 2) + (dy ^ 2)
    # ? caret-for-power: return dx ^ 2 + dy ^ 2
    # ? forgotten-square: return dx * dx + dy
    # : Only the way along x is squared. Square the way along y too.
    # ? forgotten-square: return dx + dy * dy
    # : Only the way along y is squared. Square the way along x too.
    # ? doubled-for-squared: return 2 * dx + 2 * dy
