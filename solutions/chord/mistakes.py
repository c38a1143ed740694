"""How the length of a chord goes wrong."""

from math import hypot, sqrt


def half_chord(cx, cy, r, A, B):
    "right"
    ax, ay = A[0] - cx, A[1] - cy
    # ? forgotten-centre@unused: ax, ay = A
    # ? forgotten-centre: ax, ay = A[0] - cx, A[1]
    # : Only one coordinate of the centre is subtracted. Subtract both.
    bx, by = B[0] - cx, B[1] - cy
    # ? forgotten-centre@unused: bx, by = B
    size = max(r, abs(ax), abs(ay), abs(bx), abs(by))
    # = size = max(r, hypot(ax, ay), hypot(bx, by))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), abs(A[0]), abs(A[1]), abs(B[0]), abs(B[1]))
    # ? coordinate-epsilon: size = max(1, r, abs(ax), abs(ay), abs(bx), abs(by))
    # : The threshold does not shrink with the figure: a small circle is all epsilon. Measure the
    # : size from the centre, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-9..1e-3/6}
    # ? loose-epsilon: near = 1e-4 * size
    dx, dy = B[0] - A[0], B[1] - A[1]
    # ? point-for-direction: dx, dy = B
    length = hypot(dx, dy)
    # + zero-radius: if r == 0: return None
    # @ With r = 0
    # + zero-radius: if r == 0: return 0
    # : For a radius of 0 the answer is 0, wherever the line is. It may miss the point C.
    if length == 0:
        return None
        # ? no-degenerate: return 0
        # @ If A and B are equal
        # ? no-degenerate: return 0 if abs(hypot(ax, ay) - r) <= near else None
        # : A = B is answered as a point that is on the circle, or not. There is no line then: None.
    k = dx * ay - dy * ax
    # ? swapped-coordinates: k = dx * ax + dy * ay
    # : The dot product is taken instead of the cross product, which is dx·fy − dy·fx.
    # ? global-frame: k = (B[1] - A[1]) * cx - (B[0] - A[0]) * cy + B[0] * A[1] - B[1] * A[0]
    d = abs(k) / length
    # ? not-divided: d = abs(k)
    # ? not-divided: d = abs(k) / length**2
    # : The cross product is divided by |D|², not by |D|. It is the distance times |D|: divide by the root.
    # ? global-frame: d = abs(dy / length * cx - dx / length * cy - (dy / length * A[0] - dx / length * A[1]))
    # : The line is written p·x + q·y = s, and s is as large as the distance from the origin: far away the
    # : difference to the centre's own p·x + q·y has lost its digits. Subtract the centre first.
    # ? clamped-to-segment: d = (lambda t: hypot(ax + t * dx, ay + t * dy))(min(1, max(0, -(ax * dx + ay * dy) / length**2)))
    # @ goes on for ever
    # : The distance is that of the nearest point between A and B. The line has no ends: do not clamp.
    # ? forgotten-abs: d = k / length
    # + rounded-distance: d = round(d, 9)
    # + rounded-distance: d = round(d, 6)
    if d > r + near:
        return None
        # ? zero-for-miss: return 0
        # @ misses the circle has none
    # ? sqrt-of-negative@abs: pass
    # ? sqrt-of-negative@raised: pass
    # ? equality-tangency: if d > r: return None
    if d >= r - near:
        return 0
        # ? none-for-touch: return None
        # @ a chord of length 0
        # ? nan-for-touch: return float("nan")
        # ? touch-is-diameter: return 2 * r
    # ? sqrt-of-negative@abs: if abs(d - r) <= near: return 0
    # ? sqrt-of-negative@raised: if abs(d - r) <= near: return 0
    # : Nothing keeps a line that misses the circle from the root: the program ends there. Return None first.
    # ? equality-tangency: if d == r: return 0
    # : For example, the distance is compared with the radius by ==. After a division and a root it is
    # : hardly ever the same double, and the root of what is left is 1e-8. Compare within a small part of
    # : the size.
    half = sqrt((r - d) * (r + d))
    # = half = sqrt(r * r - d * d)
    # = half = (r * r - d * d) ** 0.5
    # ? sqrt-of-negative@abs: half = sqrt(abs(r * r - d * d))
    # : The absolute value is taken under the root, "to be safe", so that a miss gets a chord as well. Return
    # : None for a miss first.
    # ? radius-not-squared: half = sqrt(max(0.0, r - d * d))
    # ? wrong-sign: half = sqrt(r * r + d * d)
    # ? squared: half = (r - d) * (r + d)
    # + clamped-to-segment: return (lambda m: max(0.0, min(length, m + half) - max(0.0, m - half)))(-(ax * dx + ay * dy) / length)
    return 2 * half
    # ? half-chord: return half
    # @ the length of the part
    # ? squared: return 4 * half * half
    # ? parameter-for-length: return 2 * half / length
    # ? multiplied-by-length: return 2 * half * length


def slope(cx, cy, r, A, B):
    "slope-intercept"
    ax, ay, bx, by = A[0] - cx, A[1] - cy, B[0] - cx, B[1] - cy
    near = 1e-10 * max(r, abs(ax), abs(ay), abs(bx), abs(by))
    if A == B:
        return None
    # + slope-intercept: if ax == bx: return None
    # : An upright line, which has no slope, is answered with None. Work with B − A and the cross product.
    m = (by - ay) / (bx - ax)
    # = m = (by - ay) / (bx - ax) if bx != ax else 0.0
    # = m = (by - ay) / ((bx - ax) or 1e-9)
    n = ay - m * ax
    d = abs(n) / sqrt(1 + m * m)
    if d > r + near:
        return None
    return 0 if d >= r - near else 2 * sqrt((r - d) * (r + d))
