"""global-frame

The line's equation p·x + q·y + s = 0 is set up in the global frame, where s is the difference of
two large products. Far from the origin nothing is left of a small figure. Subtract the centre
first, then multiply.
"""

from math import hypot


def line_count(cx, cy, r, A, B):
    (x1, y1), (x2, y2) = A, B
    if x1 == x2 and y1 == y2:
        return None
    p = y1 - y2
    q = x2 - x1
    s = float(x1) * y2 - float(x2) * y1
    d = abs(p * cx + q * cy + s) / hypot(p, q)
    e = max(r, abs(x1 - cx), abs(y1 - cy), abs(x2 - cx), abs(y2 - cy))
    if abs(d - r) <= 1e-10 * e:
        return 1
    return 2 if d < r else 0
