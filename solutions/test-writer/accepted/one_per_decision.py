"""one for each decision

A program for this problem decides a handful of things, and each case sits where one of these decisions turns. The first
cases carry most slips of the formula along: their numbers are large, slanted and all different, so that nothing that is
swapped, halved or forgotten can come out right by chance. The rest each have a single reason, which stands beside them.
"""


def cases():
    return [
        # whole numbers whose squares do not fit 64 bits, upright, both points beyond the segment's middle
        (577278628, 8063686, 47267550, (539464588, 36424209), (539464588, -48657374)),
        # an end on the circle by the band's width, the other end far away along one axis
        (33448222, -50423474, 467.9999832047118, (33447754, -50423447), (33447754, -114041990)),
        # both ends on the circle, from right to left
        (2, 1, 1, (2, 2), (0, 1)),
        # a point for a segment: on the circle by the band's width, and off it by a millionth
        (69468160, -89522176, 71303167.99994096, (69468160, -18219008), (69468160, -18219008)),
        (-762, 419, 526.0000734822, (-762, 945), (-762, 945)),
        # a miss, on the side where the cross product is negative
        (3, 0, 1, (0, 3), (0, 0)),
        # a circle that is a point, at the segment's end
        (0, -1, 0, (-3, -3), (0, -1)),
        # A is the foot of the perpendicular; the point is irrational
        (-1, -3, 3, (-1, -3), (-3, 0)),
        # a tangency of the line, beyond the segment's end
        (2, 1, 1, (-1, 0), (-3, 0)),
        # a small circle, and ends very far from it
        (0, 0, 151, (-277426592.2, 369902374.6), (277426833.8, -369902193.4)),
        # all of it tiny, and the segment much shorter than the circle is wide: a tangency in decimals
        (
            2.879366816929024e-07,
            6.246619629370425e-08,
            2.3748725652694702e-07,
            (3.482260339171911e-07, 2.9217338177014606e-07),
            (3.4820087161974425e-07, 2.9217998520905277e-07),
        ),
        # size 1, far from the origin, a miss by a millionth
        (
            -95661920.0,
            90831708.0,
            0.8905452489852905,
            (-95661921.45485002, 90831708.8905465),
            (-95661918.54514998, 90831708.8905465),
        ),
    ]
