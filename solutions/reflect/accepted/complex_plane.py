"""complex plane

The mirror image of D at the tangent is n²·conj(D) with its sign changed, n being the normal as a complex number of
length 1. The frame is turned so that the ray runs along the real axis, where n is half the chord and the height.
"""


def reflect(cx, cy, r, O, D):
    ray = complex(*D)
    if not ray or not r:
        return None
    heading = ray / abs(ray)
    to_centre = complex(cx - O[0], cy - O[1])
    slack = 1e-10 * max(r, abs(to_centre.real), abs(to_centre.imag))
    centre = to_centre * heading.conjugate()
    beyond = abs(centre.imag) - r
    if beyond > slack:
        return None
    half = 0 if beyond >= -slack else (-beyond * (r + abs(centre.imag))) ** 0.5
    for side in (-half, half):
        if centre.real + side >= -slack:
            point = complex(*O) + (centre.real + side) * heading
            if not half:
                return (point.real, point.imag), D
            normal = complex(side, -centre.imag) * heading / r
            turned = -normal * normal * ray.conjugate()
            return (point.real, point.imag), (turned.real, turned.imag)
    return None
