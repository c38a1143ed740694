"""the wall's frame

Complex numbers, turned so that the wall lies on the real axis from 0 on, and mirrored so that the disc comes from
above. The shape that the centre must not enter is a box with round ends: ask for its top, and only if that is passed
for the ends.
"""


def time_of_impact(P0, P1, r, A, B):
    p, q, a, b = (complex(*z) for z in (P0, P1, A, B))
    parts = [part for end in (a, b) for place in (p, q) for part in ((end - place).real, (end - place).imag)]
    slack = 1e-10 * max(r, max(parts), -min(parts))
    wall = abs(b - a)
    turn = ((b - a) / wall).conjugate() if wall else 1
    z, v = (p - a) * turn, (q - p) * turn
    if z.imag < 0:
        z, v = z.conjugate(), v.conjugate()
    start = abs(z - min(max(z.real, 0), wall))
    if start <= r + slack:
        return 0
    if v == 0:
        return None
    if z.imag > r and v.imag < -1e-6 * abs(v):  # not along the wall
        t = (r - z.imag) / v.imag
        if 0 <= z.real + t * v.real <= wall:
            return t if (t - 1) * abs(v) <= slack else None
    found = [t for t in (cap(z, v, r, slack), cap(z - wall, v, r, slack)) if t is not None]
    if not found:
        return None
    t = min(found)
    return t if t >= 0 and (t - 1) * abs(v) <= slack else None


def cap(z, v, r, slack):
    """When z + t·v is first on the circle of radius r about 0."""
    u = z * (v / abs(v)).conjugate()
    depth = r - abs(u.imag)
    if depth < -slack:
        return None
    return (-u.real - (depth * (r + abs(u.imag))) ** 0.5) / abs(v) if depth > slack else -u.real / abs(v)
