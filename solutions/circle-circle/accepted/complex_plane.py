"""complex plane

Moved, turned and scaled, C1 is 0 and C2 is 1: there the common points are x ± iy with |z| = p and |z − 1| = q.

Heron's product of four factors gives y without the difference of two squares.
"""

import cmath


def circle_circle(cx1, cy1, r1, cx2, cy2, r2):
    start, step = complex(cx1, cy1), complex(cx2 - cx1, cy2 - cy1)
    reach = max(r1, r2, abs(step.real), abs(step.imag))
    if abs(step) <= 1e-10 * reach:
        if reach == 0:
            return [(cx1, cy1)]
        return None if abs(r1 - r2) <= 1e-10 * reach else []
    p, q = r1 / abs(step), r2 / abs(step)
    room = 1e-10 * reach / abs(step)
    x = (1 + (p - q) * (p + q)) / 2
    product = 1.0
    for factor in (p + q - 1, 1 + p - q, 1 - p + q):
        if factor < -room:
            return []
        product *= factor if factor > room else 0
    if product == 0:
        points = [complex(p if x > 0 else -p, 0)]
    else:
        y = cmath.sqrt(product * (1 + p + q)).real / 2
        points = [complex(x, y), complex(x, -y)]
    return [((start + z * step).real, (start + z * step).imag) for z in points]
