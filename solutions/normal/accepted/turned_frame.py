"""turned frame

With the ray along the real axis the normal is known at once: its imaginary part is the centre's height over r, and the
real one is half the chord over r, against the ray. Turning back is one product.
"""


def hit_normal(cx, cy, r, O, D):
    heading = complex(*D)
    if not heading or not r:
        return None
    heading /= abs(heading)
    centre = complex(cx - O[0], cy - O[1])
    slack = 1e-10 * max(r, abs(centre.real), abs(centre.imag))
    centre *= heading.conjugate()
    height = abs(centre.imag)
    if height - r > slack:
        return None
    if height - r >= -slack:
        if centre.real < -slack:
            return None
        normal = complex(0, -1 if centre.imag > 0 else 1)
    else:
        half = ((r - height) * (r + height)) ** 0.5
        if centre.real - half >= -slack:
            normal = complex(-half, -centre.imag) / r
        elif centre.real + half >= -slack:
            normal = -complex(half, -centre.imag) / r
        else:
            return None
    normal *= heading
    return normal.real, normal.imag
