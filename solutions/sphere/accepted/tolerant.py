"""foot and half-chord, with a tolerance

The foot of the perpendicular from the centre is the middle of both points: half a chord before it the ray
enters, half a chord after it it leaves.

The distance of the line from the centre is the length of the cross product D × f by that of D, three
parts in space where the plane has one number. It is compared with r as a length, within 1e-9 of
the size; and so is the way from the origin to each of the points.

From the centre to the point is the normal, r long. It points outward, which is towards a ray that
enters; where the ray leaves, it is flipped. Which of the two it is follows from the root, not from
the sign of a product that is nearly 0 next to a touch.
"""

from math import hypot, sqrt


def ray_sphere(C, r, O, D):
    length = hypot(*D)
    if length == 0 or r == 0:
        return None
    ux, uy, uz = D[0] / length, D[1] / length, D[2] / length
    fx, fy, fz = O[0] - C[0], O[1] - C[1], O[2] - C[2]
    near = 1e-9 * max(r, abs(fx), abs(fy), abs(fz))
    d = hypot(uy * fz - uz * fy, uz * fx - ux * fz, ux * fy - uy * fx)
    gap = r - d
    if gap < -near:
        return None
    foot = -(ux * fx + uy * fy + uz * fz)
    half = sqrt(gap * (r + d)) if gap > near else 0.0
    for way, side in ((foot - half, 1), (foot + half, -1)):
        if way >= -near:
            place = way if way > near else 0.0
            scale = side / r
            normal = ((fx + way * ux) * scale, (fy + way * uy) * scale, (fz + way * uz) * scale)
            return place / length, normal
    return None
