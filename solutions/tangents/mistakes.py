"""How the tangents through a point go wrong: right ways to them, and mistakes beside the lines that they spoil."""

from cmath import exp
from fractions import Fraction
from math import acos, asin, atan2, degrees, hypot, pi, sqrt


def polar(cx, cy, r, P):
    "right"
    if r == 0:
        return [(cx, cy)]
        # ? zero-radius: return []
        # @ With r = 0
        # ? zero-radius: return [P]
        # : For a radius of 0 the answer is P. It is C, wherever P is.
    fx, fy = P[0] - cx, P[1] - cy
    # ? forgotten-centre@unused: fx, fy = P
    # @ centre C
    # : cx and cy are never used: the circle is taken to stand at the origin. Subtract the centre from P
    # : first, and add it to the points again.
    ox, oy = cx, cy
    # ? forgotten-centre@unused: ox, oy = 0, 0
    # ? forgotten-centre: ox, oy = P
    # : The points are added to P, but they were found as seen from the centre. Add them to C.
    size = max(r, abs(fx), abs(fy))
    # = size = max(r, hypot(fx, fy))
    # ? coordinate-epsilon: size = max(r, abs(cx), abs(cy), abs(P[0]), abs(P[1]))
    # ? coordinate-epsilon: size = max(1, r, abs(fx), abs(fy))
    # : The threshold does not shrink with the figure: a small circle is all epsilon. Measure the
    # : size from the centre, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-9..1e-3/6}
    # ? loose-epsilon: near = 1e-4 * size
    d = hypot(fx, fy)
    # = d = sqrt(fx * fx + fy * fy)
    # ? global-frame: d = sqrt(max(1.0, P[0] * P[0] + P[1] * P[1] - 2 * (P[0] * cx + P[1] * cy) + cx * cx + cy * cy))
    if abs(d - r) <= near:
        return [P]
        # ? on-is-none: return []
        # ? on-is-two: return [P, P]
        # @ P on the circle
    # = if d == r: return [P]
    # ? equality: if fx * fx + fy * fy == r * r: return [P]
    # : For example, |f|² is compared with r² by ==. Both are rounded: compare lengths, within a small part
    # : of the size.
    # = if (Fraction(P[0]) - Fraction(cx)) ** 2 + (Fraction(P[1]) - Fraction(cy)) ** 2 == Fraction(r) ** 2: return [P]
    # ? area-units: if abs(fx * fx + fy * fy - r * r) <= {1e-15..1e-3/12}: return [P]
    if d < r:
        return []
        # ? none-for-empty: return None
        # @ P inside the circle
    # ? sqrt-of-negative: pass
    # ? sqrt-of-negative@power: pass
    # : Inside the circle the answer has complex numbers. For example, the root of a negative number is
    # : taken by ** 0.5. Inside there is no tangent: return [].
    h = sqrt((d - r) * (d + r))
    # = h = sqrt(d * d - r * r)
    # ? sqrt-of-negative@power: h = ((d - r) * (d + r)) ** 0.5
    along, beside = (r / d) ** 2, (r / d) * (h / d)
    # ? chord-at-centre: along, beside = 0, r / d
    # ? chord-at-centre: along, beside = r / d, h / d
    # : The chord stands where the line from C to P leaves the circle. Its foot is r²/d away from C, not r.
    # ? length-as-point: along, beside = 1 - h / d, 0
    # ? length-as-point: along, beside = (h / d) ** 2, (r / d) * (h / d)
    # : h²/d is how far the foot is from P, and it is used as if it were counted from C, where it is r²/d.
    left = (ox + along * fx + beside * fy, oy + along * fy - beside * fx)
    right = (ox + along * fx - beside * fy, oy + along * fy + beside * fx)
    return [left, right]
    # ? right-first: return [right, left]
    # @ on the left of P→C
    # ? unordered: return sorted([left, right])
    # ? unordered: return sorted([left, right], key=lambda point: point[1])
    # : The points are sorted by y. Which one is left of P→C depends on where P is.


def rotated(cx, cy, r, P):
    "right"
    if r == 0:
        return [(cx, cy)]
    f = complex(P[0] - cx, P[1] - cy)
    d = abs(f)
    near = 1e-10 * max(r, d)
    if d == 0:
        return []
    # ? no-degenerate: pass
    u = f / d
    if abs(d - r) <= near:
        return [P]
    if d < r:
        return []
    angle = acos(r / d)
    # = angle = atan2(sqrt((d - r) * (d + r)), r)
    # = angle = pi / 2 - asin(r / d)
    # ? degrees-for-radians: angle = degrees(acos(r / d))
    # ? half-angle: angle = asin(r / d)
    # ? half-angle: angle = acos(r / d) / 2
    # : The angle at C is halved. It is the whole angle between CP and the radius: its cosine is r/d.
    left, right = r * u * exp(-1j * angle), r * u * exp(1j * angle)
    # ? length-as-point: left, right = sqrt(d * d - r * r) * u * exp(-1j * angle), sqrt(d * d - r * r) * u * exp(1j * angle)
    # : The points are as far from C as the tangents are long. They are on the circle: r away.
    return [(cx + p.real, cy + p.imag) for p in (left, right)]
    # ? forgotten-centre: return [(p.real, p.imag) for p in (left, right)]
    # : The points are as seen from the centre: it was subtracted from P, and never added again.


def thales(cx, cy, r, P):
    "right"
    if r == 0:
        return [(cx, cy)]
    fx, fy = P[0] - cx, P[1] - cy
    d = hypot(fx, fy)
    if abs(d - r) <= 1e-10 * max(r, d):
        return [P]
    if d < r:
        return []
    away = d / 2
    radius = d / 2
    # ? thales-wrong-radius: radius = d
    # ? thales-wrong-radius: radius = sqrt(d * d - r * r) / 2
    # : The second circle has half the tangent's length for its radius. It goes through C and P: half of |P − C|.
    foot = (r * r - radius * radius + away * away) / (2 * away)
    half = sqrt(max(0.0, (r - foot) * (r + foot)))
    ux, uy = fx / d, fy / d
    left = (cx + foot * ux + half * uy, cy + foot * uy - half * ux)
    right = (cx + foot * ux - half * uy, cy + foot * uy + half * ux)
    return [left, right]


def slopes(cx, cy, r, P):
    "slope-intercept"
    fx, fy = P[0] - cx, P[1] - cy
    d = hypot(fx, fy)
    if r == 0:
        return [(cx, cy)]
    if abs(d - r) <= 1e-10 * max(r, d):
        return [P]
    if d < r:
        return []
    a = fx * fx - r * r
    root = r * sqrt(d * d - r * r)
    found = []
    for s in (1, -1):
        # + slope-intercept: if a == 0: return []
        # : A tangent that is vertical has no slope, and is answered with []. Work with vectors.
        m = (fx * fy + s * root) / a
        n = fy - m * fx
        found.append((-m * n / (1 + m * m), n / (1 + m * m)))
    left, right = sorted(found, key=lambda p: fx * p[1] - fy * p[0])
    return [(cx + left[0], cy + left[1]), (cx + right[0], cy + right[1])]
