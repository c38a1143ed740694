"""one for each decision

A program for this problem decides a handful of things, and each case sits where one of these decisions turns. The first
case carries most slips of the formula along: its numbers are slanted and all different, so that nothing that is swapped,
halved or forgotten can come out right by chance. The rest each have a single reason, which stands beside them.
"""


def cases():
    return [
        # small, far from the origin; the line is slanted, and the segment begins inside and leaves the circle
        (76346568.6352663, -53152878.57018185, 0.0024261474609375,
         (76346568.63400078, -53152878.56963253), (76346568.63194466, -53152878.57293701)),
        # a circle that is a point, at the segment's end
        (2.0, -3.0, 0.0, (0.0, 0), (2.0, -3.0)),
        # tiny: an end that is off the circle by a millionth of its size
        (0.0, 0.0, 3.4776391835689147e-12,
         (1.997899308371073e-12, 4.558430313877063e-12), (-4.8529556444068566e-12, 1.789520212674115e-12)),
        # a miss, on the side where the cross product is negative
        (-3, 1, 0, (2, -3), (1, 2)),
        # an upright tangent that touches beyond the segment's end, in decimals
        (0, 0, 0.9, (-0.9, -0.17), (-0.9, -0.01)),
        # A is the centre, the foot of the perpendicular; the products leave 32 bits
        (0, 9, 442, (0, 9), (1110, 601)),
        # a point for a segment: on the circle, where squares are rounded, and off it by a millionth
        (-304675555, -26672675, 391627145, (-683603727.0, -125593154), (-683603727, -125593154.0)),
        (0, 0, 0.1275545358657837,
         (0.0963111125092837, 0.0836318183082767), (0.0963111125092837, 0.0836318183082767)),
        # an end on the circle, the other one far away
        (0, 0, 85.0, (13, -84), (-1354515, -1015980)),
        # the same with products that leave 64 bits, and the end just off the circle
        (0, 0, 3788800, (-997609472, -287236096), (-2181392, 3097094)),
        # the ends are close together, and the line nearly is a tangent
        (0, 0, 28340, (-39340, 7660), (-39340.0000000922, 7660.000000136788)),
    ]  # fmt: skip
