"""figures moved about

A few figures of whole numbers say what may happen: through, touching, ends on and beside the circle, points for
segments. Each is then turned by a Pythagorean angle, scaled and shifted, so that the same thing happens at an odd angle,
tiny, huge or far away, where a threshold of the wrong size and lost digits show.
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
        moved(through, scale=101_000_000),  # too large for 64 bits
        (0, 0, 151, (-277426592.2, 369902374.6), (277426833.8, -369902193.4)),  # touches, and is very long
        moved((0, 0, 5, (3, 4), (-4.9999, 0)), turn=(4, 3), scale=0.1, shift=(1e4, 0)),  # on it, to just inside
        moved((0, 0, 1, (-3, 1), (4, 1)), turn=(20, 21), scale=0.1, shift=(0, 1e4)),  # touches, at an odd angle
        moved((0, 0, 1, (2, 1), (4, 1))),  # would touch, before it begins
        moved((0, 0, 1, (-2, -1.000001), (2, -1.000001)), shift=(2e5, -1e5)),  # misses by a millionth
        moved((0, 0, 5, (3, 4), (3, 4)), turn=(5, 12), scale=0.1, shift=(1e4, 0)),  # a point on the circle
        moved((0, 0, 5, (3, 4.00001), (3, 4.00001)), scale=2**-30),  # and one beside it
        moved((0, 0, 0, (-1, -1), (2, 2)), shift=(7, 3)),  # a circle that is a point
        moved((0, 0, 5, (3, 3.999999), (-3000000, -4000003))),  # on it, as far as such a length can tell
        moved((0, 0, 1, (0, -0.9), (0, -1.1)), scale=2e-9),  # short, across it
        moved((2, 1, 5, (2, 1), (-20, -23)), scale=0.1, shift=(8e7, -9e7)),  # from the centre, far away
    ]
