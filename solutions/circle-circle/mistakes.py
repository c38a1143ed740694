"""How two circles go wrong: right ways to their common points, and mistakes beside the lines that they spoil."""

from cmath import exp
from math import acos, atan2, degrees, hypot, sqrt


def radical(cx1, cy1, r1, cx2, cy2, r2):
    "right"
    # + swapped-radii: r1, r2 = r2, r1
    vx, vy = cx2 - cx1, cy2 - cy1
    # = vx, vy = -(cx1 - cx2), -(cy1 - cy2)
    # ? forgotten-centre@unused: vx, vy = cx2, cy2
    # : cx1 and cy1 are never used: the first circle is taken to stand at the origin. Take v = C2 − C1, and add
    # : C1 to the points again.
    ox, oy = cx1, cy1
    # ? forgotten-centre@unused: ox, oy = 0, 0
    # ? forgotten-centre: ox, oy = cx2, cy2
    # : The points are as seen from C1, but they are added to C2.
    size = max(r1, r2, abs(vx), abs(vy))
    # = size = max(r1, r2, hypot(vx, vy))
    # ? coordinate-epsilon: size = max(r1, r2, abs(cx1), abs(cy1), abs(cx2), abs(cy2))
    # ? coordinate-epsilon: size = max(1, r1, r2, abs(vx), abs(vy))
    # : The threshold does not shrink with the figure: small circles are all epsilon. Measure the
    # : size by the radii and C2 − C1, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-9..1e-3/6}
    # ? area-units@squares: near = {1e-9..1e-6/3}
    # ? equality: near = 0
    # ? loose-epsilon: near = 1e-4 * size
    d = hypot(vx, vy)
    # = d = sqrt(vx * vx + vy * vy)
    # ? global-frame: d = sqrt(max(1e-9, cx1 * cx1 + cy1 * cy1 - 2 * (cx1 * cx2 + cy1 * cy2) + cx2 * cx2 + cy2 * cy2))
    if size == 0:
        return [(cx1, cy1)]
        # ? no-degenerate: return []
        # ? no-degenerate: return None
        # : Two points that are the same are answered as two circles that are the same, with None. Their common
        # : point is one: [C1].
    # + zero-radius: if r1 == 0 or r2 == 0: return []
    # @ With radius 0
    # + zero-radius: if r1 == 0 or r2 == 0: return None
    # : Where a radius is 0 None is returned, as if there were no circle. The circle is a point then.
    if d <= near:
        return None if abs(r1 - r2) <= near else []
        # ? same-is-empty: return []
        # @ One and the same circle
        # ? same-is-empty: return [] if abs(r1 - r2) <= near else None
        # : About one centre None and [] are exchanged: circles that differ have no point, [].
    outer, inner = d - (r1 + r2), d - abs(r1 - r2)
    # ? area-units@squares: outer, inner = d * d - (r1 + r2) ** 2, d * d - (r1 - r2) ** 2
    if outer > near:
        return []
        # ? none-for-empty: return None
        # @ No common point
    # ? sqrt-of-negative: pass
    if inner < -near:
        return []
        # ? none-for-empty: return None
    # ? inside-crosses: pass
    # @ One circle inside the other has none
    # : One circle inside the other goes the way of two that cross: the root is that of a negative number. Ask
    # : for d < |r1 − r2| as well.
    # ? inside-crosses@abs: pass
    # : One circle inside the other goes the way of two that cross, and the root is taken of an absolute value.
    # : Ask for d < |r1 − r2| as well.
    a = (d + (r1 - r2) * ((r1 + r2) / d)) / 2
    # = a = (d * d + r1 * r1 - r2 * r2) / (2 * d)
    # ? radical-line-sign: a = (d - (r1 - r2) * ((r1 + r2) / d)) / 2
    # ? radical-line-sign: a = d + (r1 - r2) * ((r1 + r2) / d)
    # : The line is twice as far away as it should be: a = (d² + r1² − r2²) / (2d), with the 2.
    ux, uy = vx / d, vy / d
    if abs(outer) <= near:
        return [(ox + r1 * ux, oy + r1 * uy)]
        # ? tangent-twice: return [(ox + r1 * ux, oy + r1 * uy), (ox + r1 * ux, oy + r1 * uy)]
        # @ the point once
        # ? touch-missed: return []
    if abs(inner) <= near:
        s = r1 if r1 > r2 else -r1
        # ? inner-missed: s = r1
        # : Where one circle touches the other from inside, the point is always taken towards C2. If the second
        # : circle is the greater one, it is on the other side of C1.
        return [(ox + s * ux, oy + s * uy)]
        # ? tangent-twice: return [(ox + s * ux, oy + s * uy), (ox + s * ux, oy + s * uy)]
    # ? inner-missed: pass
    # : Only a touch from outside is looked for: one from inside comes out as two points that are nearly the same.
    # : Compare d with |r1 − r2| as well.
    h = sqrt((r1 - a) * (r1 + a))
    # = h = sqrt(abs(r1 * r1 - a * a))
    # = h = sqrt(max(0.0, (r1 - a) * (r1 + a)))
    # ? inside-crosses@abs: h = sqrt(abs((r1 - a) * (r1 + a)))
    left, right = (ox + a * ux - h * uy, oy + a * uy + h * ux), (ox + a * ux + h * uy, oy + a * uy - h * ux)
    return [left, right]
    # ? right-first: return [right, left]
    # @ on the left of C1→C2
    # ? unordered: return sorted([left, right])
    # ? unordered: return sorted([left, right], key=lambda point: atan2(point[1] - cy1, point[0] - cx1))
    # : The points are sorted by their angles, which jump from π to −π on one side of the circle. Take the left
    # : one by its formula.


def cosines(cx1, cy1, r1, cx2, cy2, r2):
    "right"
    v = complex(cx2 - cx1, cy2 - cy1)
    d = abs(v)
    near = 1e-10 * max(r1, r2, d)
    if d <= near:
        if r1 == 0 and r2 == 0:
            return [(cx1, cy1)]
        return None if abs(r1 - r2) <= near else []
    # ? division-by-zero: pass
    if d > r1 + r2 + near or d < abs(r1 - r2) - near:
        return []
    # ? inside-crosses: if d > r1 + r2 + near: return []
    # : One circle inside the other goes the way of two that cross: the cosine is more than 1. Ask for
    # : d < |r1 − r2| as well.
    # ? sqrt-of-negative: if d < abs(r1 - r2) - near: return []
    # : Circles that are apart go the way of two that cross: the cosine is more than 1. Decide first.
    u = v / d * r1
    if d >= r1 + r2 - near:
        return [(cx1 + u.real, cy1 + u.imag)]
    if d <= abs(r1 - r2) + near:
        s = 1 if r1 > r2 else -1
        return [(cx1 + s * u.real, cy1 + s * u.imag)]
        # ? inner-missed: return []
    cosine = d * d + r1 * r1 - r2 * r2
    angle = atan2(sqrt((d + r1 - r2) * (d + r2 - r1) * (r1 + r2 - d) * (d + r1 + r2)), cosine)
    # ? degrees-for-radians: angle = degrees(acos(max(-1.0, min(1.0, cosine / (2 * d * r1)))))
    left, right = u * exp(1j * angle), u * exp(-1j * angle)
    return [(cx1 + p.real, cy1 + p.imag) for p in (left, right)]
    # ? forgotten-centre: return [(p.real, p.imag) for p in (left, right)]
    # : The points are as seen from C1: it was subtracted, and never added again.
