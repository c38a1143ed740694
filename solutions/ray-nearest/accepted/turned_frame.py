"""turned frame

The frame is turned so that the ray runs along the x axis; then the circle is a matter of one number, its centre.
"""


def ray_nearest(cx, cy, r, O, D):
    speed = abs(complex(*D))
    if speed == 0.0:
        return None
    heading = complex(*D) / speed
    to_centre = complex(cx - O[0], cy - O[1])
    slack = 1e-10 * max(r, abs(to_centre.real), abs(to_centre.imag))

    centre = to_centre * heading.conjugate()
    clear = r - abs(centre.imag)
    if clear < -slack:
        return None
    if clear <= slack:
        entry = leave = centre.real
    else:
        half = (clear * (r + abs(centre.imag))) ** 0.5
        power = to_centre.real * to_centre.real + to_centre.imag * to_centre.imag - r * r
        outer = centre.real + half if centre.real > 0 else centre.real - half
        entry, leave = sorted((outer, power / outer))

    if abs(entry) <= slack or abs(leave) <= slack < -entry:
        return 0.0
    if entry > 0:
        return entry / speed
    return leave / speed if leave > 0 else None
