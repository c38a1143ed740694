"""its own circle by its side

The circle that is hit is never asked by its roots: from outside it can't be in the way, from inside it is if the light is
outside. All others have no root near the point, so that no threshold is needed at all.
"""

from cmath import phase, rect


def light(circles, O, D, L):
    turn = rect(1, -phase(complex(*D)))
    scene = [(complex(x - O[0], y - O[1]) * turn, r) for x, y, r in circles]
    lamp = complex(L[0] - O[0], L[1] - O[1]) * turn
    hits = []
    for index, (c, r) in enumerate(scene):
        if abs(c.imag) < r:
            half = ((r - c.imag) * (r + c.imag)) ** 0.5
            hits += [(c.real - half, index, False), (c.real + half, index, True)]
    ahead = [hit for hit in hits if hit[0] > 0]
    if not ahead:
        return None
    place, own, inside = min(ahead)
    centre, radius = scene[own]
    normal, way = place - centre, lamp - place
    faces_out = normal.real * way.real + normal.imag * way.imag > 0
    if faces_out == inside:
        return "dark"
    if inside and abs(lamp - centre) > radius:
        return "dark"
    to_light = way.conjugate() / abs(way)
    for index, (c, r) in enumerate(scene):
        seen = (c - place) * to_light  # the way to the light is the x axis now
        if index == own or abs(seen.imag) >= r:
            continue
        half = ((r - seen.imag) * (r + seen.imag)) ** 0.5
        if 0 < seen.real - half < abs(way) or 0 < seen.real + half < abs(way):
            return "dark"
    return "lit"
