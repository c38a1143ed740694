"""figures moved about

A few figures of whole numbers say what may happen: through, touching, ends on and beside the circle, points for
segments. Each is then turned by a Pythagorean angle, scaled by a power of two and shifted by whole numbers, so that the
same thing happens, exactly, at an odd angle, tiny, huge or far away, where a threshold of the wrong size and lost digits
show.
"""


def moved(case, turn=(1, 0), scale=1, shift=(0, 0)):
    """The case with everything turned (and lengthened) by the vector `turn`, then scaled, then shifted."""
    cx, cy, r, A, B = case
    p, q = turn
    length = round((p * p + q * q) ** 0.5)  # whole, for Pythagorean pairs

    def image(x, y):
        return (p * x - q * y) * scale + shift[0], (q * x + p * y) * scale + shift[1]

    return (*image(cx, cy), r * length * scale, image(*A), image(*B))


def cases():
    through = (2, 1, 5, (9, 4), (-7, -2))  # from right to left
    return [
        moved(through, turn=(20, 21), scale=2_000_001),  # too large for 64 bits
        moved((0, 0, 5, (-9, 5), (4, 5)), turn=(20, 21), scale=2**-20, shift=(8e7, -9e7)),  # touches, far from the origin
        moved((0, 0, 12345677, (-1234567, 12345677), (2345678, 12345677)), turn=(2079, 2600), scale=2**-9),  # touches
        moved((0, 0, 1, (2, 1), (4, 1)), turn=(-4, -3), scale=2**-40),  # touches before it begins
        moved((0, 0, 1, (0, 0), (0, -7))),  # upright, from the centre
        moved((0, 0, 10**7, (-2 * 10**7, -(10**7) - 9), (10**7, -(10**7) - 9)), scale=2**-20, shift=(0, 10**8)),  # misses by a hair, far away
        moved((0, 0, 12345677, (12345677, 0), (12345677, 0)), turn=(2079, 2600), scale=2**-9),  # a point on the circle
        moved((0, 0, 5 * 10**5, (3 * 10**5, 4 * 10**5 + 1), (3 * 10**5, 4 * 10**5 + 1)), scale=2**-40),  # one beside it
        moved((0, 0, 0, (-1, -1), (2, 2)), shift=(7, 3)),  # a circle that is a point
        moved((0, 0, 85, (13, -84), (-1354515, -1015980))),  # on the circle, the other end far away
        moved((0, 0, 10, (-1, 9), (1, 11)), turn=(4, 3), scale=2**-33),  # short, across it
        moved((0, 0, 28340, (-39340, 7660), (-39340.0000000922, 7660.000000136788))),  # hardly any length
    ]
