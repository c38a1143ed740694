"""How the circle on a diameter goes wrong: right ways to it, and mistakes beside the lines that they spoil."""

from math import dist, hypot, isqrt


def wrap(x):
    return (x + (1 << 31)) % (1 << 32) - (1 << 31)


def square(x, y):
    return x * x + y * y


def sign(x):
    return (x > 0) - (x < 0)


def doubled(A, B, P):
    "right"
    sx, sy = A[0] + B[0], A[1] + B[1]
    # ? sum-for-difference: sx, sy = B[0] - A[0], B[1] - A[1]
    # ? centre-at-an-end: sx, sy = 2 * A[0], 2 * A[1]
    # @ half-way between
    # ? centre-at-an-end: sx, sy = 2 * B[0], 2 * B[1]
    # : B is taken for the centre. The centre is half-way between A and B.
    # ? floor-division: sx, sy = (A[0] + B[0]) // 2 * 2, (A[1] + B[1]) // 2 * 2
    # @ need not be whole
    # ? forgotten-half: sx, sy = 2 * (A[0] + B[0]), 2 * (A[1] + B[1])
    # : A + B is taken for the centre. It is twice the centre: take 2·P as well.
    # ? swapped-coordinates: sx, sy = A[1] + B[1], A[0] + B[0]
    dx, dy = 2 * P[0] - sx, 2 * P[1] - sy
    # ? forgotten-half: dx, dy = P[0] - sx, P[1] - sy
    # : P is left as it is, and A + B is twice the centre. Take 2·P.
    ux, uy = B[0] - A[0], B[1] - A[1]
    # = ux, uy = A[0] - B[0], A[1] - B[1]
    # ? sum-for-difference: ux, uy = A[0] + B[0], A[1] + B[1]
    # : The diameter is made of A + B. It goes from A to B: take B - A.
    # + float-arithmetic: dx, dy, ux, uy = float(dx), float(dy), float(ux), float(uy)
    # : The numbers are made floats, whose squares hold about 16 digits. Leave them whole.
    away = dx * dx + dy * dy
    # = away = dx**2 + dy**2
    # ? caret-for-power@both: away = (dx ^ 2) + (dy ^ 2)
    # ? caret-for-power: away = (dx ^ 2) + (dy ^ 2)
    # ? minus-for-plus: away = abs(dx * dx - dy * dy)
    # ? steps-for-distance@steps: away = abs(dx) + abs(dy)
    # ? steps-for-distance: away = (abs(dx) + abs(dy)) ** 2
    # ? overflow-32@wide: away = wrap(dx * dx + dy * dy)
    # @ of whole numbers
    # ? rounded-root@root: away = isqrt(dx * dx + dy * dy)
    # ? forgotten-square: away = hypot(dx, dy)
    # ? diameter-for-radius: away = (dx * dx + dy * dy) / 4
    # : The radius is taken as long as the diameter. It is half of that, and its square a quarter.
    across = ux * ux + uy * uy
    # = across = ux**2 + uy**2
    # ? caret-for-power@both: across = (ux ^ 2) + (uy ^ 2)
    # ? minus-for-plus: across = abs(ux * ux - uy * uy)
    # ? steps-for-distance@steps: across = abs(ux) + abs(uy)
    # ? overflow-32@wide: across = wrap(ux * ux + uy * uy)
    # ? rounded-root@root: across = isqrt(ux * ux + uy * uy)
    # ? rounded-root: across = isqrt(ux * ux + uy * uy) ** 2
    # : The diameter is rounded down to a whole number and squared again. |B - A|² is whole as it is.
    # ? forgotten-square: across = hypot(ux, uy)
    # : For example, the distance squared is compared with the diameter itself. Square both.
    # ? diameter-for-radius: across = (ux * ux + uy * uy) // 4
    # : A quarter of |B - A|² is r², but the rest of the figure is doubled. Compare with |B - A|² as it is.
    # ? nearly-on-is-on: across = away if abs(away - ux * ux - uy * uy) <= 4 else ux * ux + uy * uy
    # ? nearly-on-is-on: away, across = (lambda d, r: (r if abs(d - r) <= 1e-4 else d, r))(hypot(dx, dy), hypot(ux, uy))
    # ? box-for-circle: away, across = max(abs(dx), abs(dy)), max(abs(ux), abs(uy))
    if away < across:
        return -1
        # ? sides-exchanged@sign: return 1
        # ? number-for-sign@sign: return away - across
        # ? boolean-answer@sign: return True
        # ? edge-missed: return 0
        # @ if it is on the circle
        # : What is inside is answered with 0. It is -1; only a point on the circle is 0.
    if away > across:
        return 1
        # ? sides-exchanged@sign: return -1
        # ? number-for-sign@sign: return away - across
        # ? boolean-answer@sign: return False
        # ? edge-missed: return 0
        # : What is outside is answered with 0. It is 1; only a point on the circle is 0.
    return 0
    # ? boolean-answer@sign: return False


def angle(A, B, P):
    "right"
    ax, ay = A[0] - P[0], A[1] - P[1]
    bx, by = B[0] - P[0], B[1] - P[1]
    # = ax, ay, bx, by = P[0] - A[0], P[1] - A[1], P[0] - B[0], P[1] - B[1]
    # ? from-world-origin: ax, ay, bx, by = *A, *B
    # ? sum-for-difference: ax, ay, bx, by = A[0] + P[0], A[1] + P[1], B[0] + P[0], B[1] + P[1]
    # : P is added where it has to be subtracted. The way from P to A is A - P.
    # ? centre-at-an-end: bx, by = B[0] - A[0], B[1] - A[1]
    # : The angle is taken at A, between B and P. The right angle is at P: take A - P and B - P.
    dot = ax * bx + ay * by
    # ? cross-for-dot: dot = ax * by - ay * bx
    # ? minus-for-plus: dot = ax * bx - ay * by
    # : The two products are subtracted. The scalar product is ax·bx + ay·by.
    # ? overflow-32: dot = wrap(ax * bx) + wrap(ay * by)
    # ? float-arithmetic: dot = float(ax) * bx + float(ay) * by
    # : The products are made of floats, which hold about 16 digits. Leave the numbers whole.
    # ? float-arithmetic: dot = hypot(ax, ay) ** 2 + hypot(bx, by) ** 2 - dist(A, B) ** 2
    # : The distances are roots, which are rounded before they are squared again. Take the squares themselves.
    return (dot > 0) - (dot < 0)
    # ? number-for-sign: return dot
    # ? edge-missed: return 1 if dot > 0 else -1
    # ? edge-missed: return 1 if dot >= 0 else -1


def centred(A, B, P):
    "right"
    mx, my = (A[0] + B[0]) / 2, (A[1] + B[1]) / 2
    r2 = square(B[0] - A[0], B[1] - A[1])
    # ? floor-division: r2 = square(B[0] - A[0], B[1] - A[1]) // 4 * 4
    # : A quarter of |B - A|² is cut down to a whole number. Double the rest instead.
    # ? floor-division: r2 = square(isqrt(square(B[0] - A[0], B[1] - A[1])) // 2, 0) * 4
    # : The radius is rounded down to a whole number. Compare squares, with nothing halved.
    return sign(square(int(2 * P[0] - 2 * mx), int(2 * P[1] - 2 * my)) - r2)
    # ? centre-at-an-end: return sign(square(P[0] - A[0], P[1] - A[1]) - r2)
    # : The circle around A through B is taken. The centre is half-way between A and B.
    # ? box-for-circle: return -1 if all(min(a, b) <= p <= max(a, b) for a, b, p in zip(A, B, P)) else 1
    # ? float-arithmetic: return sign(dist(P, (mx, my)) - dist(A, B) / 2)
