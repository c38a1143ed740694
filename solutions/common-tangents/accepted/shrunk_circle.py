"""shrunk circle

Let the second circle shrink to its centre, and the first one by as much: tangents from a point to a circle remain.

For outer tangents the first circle gets the radius r1 − r2, and for inner ones r1 + r2; a negative radius touches on
the far side. The points are then moved out along their radii. In the complex plane, the touching direction is z with
z·conj(v) = q ± i√(d² − q²), one long.
"""

import cmath


def common_tangents(cx1, cy1, r1, cx2, cy2, r2):
    v = complex(cx2 - cx1, cy2 - cy1)
    away = abs(v)
    size = max(r1, r2, abs(v.real), abs(v.imag))
    found = []
    for radius in (r1 - r2, r1 + r2):
        clear = away - abs(radius)
        if clear < -1e-9 * size:
            continue
        if clear <= 1e-9 * size:
            sides = [complex(radius / abs(radius), 0) * v / away]
        else:
            root = cmath.sqrt(clear * (away + abs(radius))).real
            sides = [complex(radius, root) / away * v / away, complex(radius, -root) / away * v / away]
        found += [(cx1 + r1 * side.real, cy1 + r1 * side.imag) for side in sides]
    return found
