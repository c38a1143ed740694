"""How "inside, on or outside" goes wrong."""

from fractions import Fraction
from math import hypot, sqrt


def lengths(cx, cy, r, P):
    "right"
    fx, fy = P[0] - cx, P[1] - cy
    # = fx, fy = cx - P[0], cy - P[1]
    # ? forgotten-centre: fx, fy = P
    # ? shortest-decimal: fx, fy = (float(Fraction(str(p)) - Fraction(str(c))) for p, c in zip(P, (cx, cy)))
    # ? forgotten-centre: fx, fy = P[0] + cx, P[1] + cy
    # : The centre is added to P. Seen from the centre, P is P − C.
    size = max(r, abs(fx), abs(fy))
    # = size = max(r, hypot(fx, fy))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), abs(P[0]), abs(P[1]))
    # ? coordinate-epsilon: size = max(1, r, abs(fx), abs(fy))
    # : The threshold does not shrink with the figure: a small circle is all epsilon. Measure the
    # : size from the centre, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # = near = 1e-10 * r
    # ? absolute-epsilon: near = {1e-9..1e-3/6}
    # ? loose-epsilon: near = 1e-4 * size
    d = hypot(fx, fy)
    # = d = sqrt(fx * fx + fy * fy)
    # ? manhattan: d = abs(fx) + abs(fy)
    # ? manhattan: d = max(abs(fx), abs(fy))
    # : The distance is taken as the larger of |fx| and |fy|. It is the root of fx² + fy².
    # ? squared: d = fx * fx + fy * fy
    # ? global-frame: d = sqrt(max(0.0, P[0] * P[0] + P[1] * P[1] - 2 * (P[0] * cx + P[1] * cy) + cx * cx + cy * cy))
    # + rounded-distance: d = round(d, 9)
    # + rounded-distance: d = round(d, 6)
    # + zero-radius: if r == 0: return 1
    # @ With r = 0
    # + zero-radius: if r == 0: return 0
    # : For a radius of 0 the answer is 0, wherever P is. The circle is the point C then.
    if abs(d - r) <= near:
        return 0
        # ? boolean: return True
        # ? boolean@both: return True
        # ? only-on-or-off: return 1
        # @ if P is inside
    # = if d == r: return 0
    # ? equality: if fx * fx + fy * fy == r * r: return 0
    # : For example, |f|² is compared with r² by ==. Both are rounded: compare lengths, within a small part
    # : of the size.
    # = if (Fraction(P[0]) - Fraction(cx)) ** 2 + (Fraction(P[1]) - Fraction(cy)) ** 2 == Fraction(r) ** 2: return 0
    # ? strict-less: if d == r: return 1
    # ? strict-less: if abs(d - r) <= near: return -1
    # : A point on the circle is called inside. It is on it: 0.
    # ? area-units: if abs(fx * fx + fy * fy - r * r) <= {1e-15..1e-6/9}: return 0
    # ? loose-epsilon: if abs(d - r) <= 1e-8 + 1e-5 * r: return 0
    # : For example, the lengths are compared as np.isclose does, within 1e-5 of the radius. Compare within
    # : 1e-9 of the size.
    return 1 if d > r else -1
    # ? boolean@both: return False
    # ? only-on-or-off: return -1
    # : A point that is not on the circle is said to be inside. Outside is 1.
    # ? swapped-sides: return -1 if d > r else 1
    # @ if it is outside
