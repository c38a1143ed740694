"""How inside, on and outside go wrong: right ways to it, and mistakes beside the lines that they spoil."""

from math import hypot, isqrt, sqrt


def wrap(x):
    return (x + (1 << 31)) % (1 << 32) - (1 << 31)


def squares(cx, cy, r, P):
    "right"
    dx, dy = P[0] - cx, P[1] - cy
    # = dx, dy = cx - P[0], cy - P[1]
    # = dx, dy = abs(P[0] - cx), abs(P[1] - cy)
    # ? forgotten-centre: dx, dy = P[0] - cx, P[1]
    # @ centre C
    # : The centre is subtracted in x only. Subtract it in y as well.
    # ? forgotten-centre: dx, dy = P[0], P[1] - cy
    # : The centre is subtracted in y only. Subtract it in x as well.
    # ? sum-for-difference: dx, dy = P[0] + cx, P[1] + cy
    # ? sum-for-difference: dx, dy = abs(P[0]) - abs(cx), abs(P[1]) - abs(cy)
    # : abs is taken of each coordinate before they are subtracted, and -3 and 3 come out as one place. Subtract first.
    # ? swapped-coordinates: dx, dy = P[0] - cy, P[1] - cx
    # + float-arithmetic: dx, dy = float(dx), float(dy)
    # : The differences are made floats, whose squares hold about 16 digits. Leave them whole.
    square = dx * dx + dy * dy
    # = square = dx**2 + dy**2
    # ? steps-for-distance: square = (abs(dx) + abs(dy)) ** 2
    # ? box-for-circle: square = max(abs(dx), abs(dy)) ** 2
    # ? caret-for-power: square = (dx ^ 2) + (dy ^ 2)
    # ? minus-for-plus: square = dx * dx - dy * dy
    # ? float-arithmetic@hypot: square = hypot(dx, dy)
    # ? rounded-root@whole: square = isqrt(dx * dx + dy * dy)
    # ? rounded-root@near: square = round(sqrt(dx * dx + dy * dy))
    # ? overflow-32@wide: square = wrap(dx * dx + dy * dy)
    # @ All numbers are whole
    # ? forgotten-square: square = abs(dx) + abs(dy)
    # : dx and dy are not squared, but r is. Square all three.
    limit = r * r
    # = limit = r**2
    # ? forgotten-square: limit = r
    # ? caret-for-power: limit = r ^ 2
    # ? doubled-for-squared: limit = 2 * r
    # : r is doubled, not squared. Write `r * r` or `r ** 2`.
    # ? float-arithmetic@hypot: limit = r
    # ? rounded-root@whole: limit = r
    # ? rounded-root@near: limit = r
    # ? overflow-32@wide: limit = wrap(r * r)
    # ? nearly-on-is-on: limit = square if abs(square - r * r) <= 1 else r * r
    # ? nearly-on-is-on: square, limit = (lambda d: (r if abs(d - r) <= 1e-4 else d, r))(sqrt(square))
    if square < limit:
        return -1
        # ? sides-exchanged@sign: return 1
        # ? number-for-sign@sign: return square - limit
        # ? boolean-answer@sign: return True
        # ? edge-missed: return 0
        # @ if it is on the circle
        # : What is inside is answered with 0. It is -1; only a point on the circle is 0.
        # ? boolean-answer: return False
        # : False is returned for the inside. The answer is a number: -1.
    if square > limit:
        return 1
        # ? sides-exchanged@sign: return -1
        # ? number-for-sign@sign: return square - limit
        # ? boolean-answer@sign: return False
    return 0
    # ? edge-missed: return None
    # : A point on the circle gets None. It is a place like the others: return 0.
    # ? boolean-answer@sign: return False
