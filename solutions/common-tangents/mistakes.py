"""How common tangents go wrong: right ways to them, and mistakes beside the lines that they spoil."""

from cmath import exp
from math import acos, degrees, hypot, sqrt


def normals(cx1, cy1, r1, cx2, cy2, r2):
    "right"
    # + swapped-radii: r1, r2 = r2, r1
    vx, vy = cx2 - cx1, cy2 - cy1
    # ? forgotten-centre@unused: vx, vy = cx2, cy2
    # @ The first circle has centre
    # : cx1 and cy1 are never used: the first circle is taken to stand at the origin. Take v = C2 − C1, and add
    # : C1 to the points again.
    ox, oy = cx1, cy1
    # ? forgotten-centre@unused: ox, oy = 0, 0
    # ? forgotten-centre: ox, oy = 0, 0
    # : The points are as seen from C1: it was subtracted, and never added again.
    # ? on-circle-2@other: ox, oy = cx2, cy2
    # @ touch the **first** circle
    size = max(r1, r2, abs(vx), abs(vy))
    # = size = max(r1, r2, hypot(vx, vy))
    # ? coordinate-epsilon: size = max(r1, r2, abs(cx1), abs(cy1), abs(cx2), abs(cy2))
    # ? coordinate-epsilon: size = max(1, r1, r2, abs(vx), abs(vy))
    # : The threshold does not shrink with the figure: small circles are all epsilon. Measure the
    # : size by the radii and C2 − C1, and add nothing to it.
    near = 1e-10 * size
    # = near = 1e-9 * size
    # ? absolute-epsilon: near = {1e-9..1e-3/6}
    # ? equality: near = 0
    # ? loose-epsilon: near = 1e-4 * size
    d = hypot(vx, vy)
    # = d = sqrt(vx * vx + vy * vy)
    # ? global-frame: d = sqrt(max(1e-9, cx1 * cx1 + cy1 * cy1 - 2 * (cx1 * cx2 + cy1 * cy2) + cx2 * cx2 + cy2 * cy2))
    ux, uy = vx / d, vy / d
    length = r1
    # ? on-circle-2@other: length = r2
    found = []
    sums = (r1 - r2, r1 + r2)
    # ? inner-first: sums = (r1 + r2, r1 - r2)
    # @ First the outer tangents
    for q in sums:
        gap = d - abs(q)
        if gap < -near:
            continue
        # ? sqrt-of-negative: pass
        if gap <= near:
            c = 1 if q > 0 else -1
            # ? inner-side: c = 1
            found.append((ox + length * c * ux, oy + length * c * uy))
            # ? tangent-twice: found += [(ox + length * c * ux, oy + length * c * uy)] * 2
            # @ both inner tangents are one
            # ? touch-missed: pass
            continue
        c = q / d
        h = sqrt((d - q) * (d + q)) / d
        # = h = sqrt(1 - c * c)
        left = (ox + length * (c * ux - h * uy), oy + length * (c * uy + h * ux))
        right = (ox + length * (c * ux + h * uy), oy + length * (c * uy - h * ux))
        found += [left, right]
        # ? right-first: found += [right, left]
        # @ on the left of C1→C2
        # ? unordered: found += sorted([left, right])
    return found
    # ? inside-crosses: return found or [(ox + length * ux, oy + length * uy)]
    # @ One inside the other has none
    # ? none-for-empty: return found or None
    # ? unordered: return sorted(found)
    # : All the points are sorted by x. The outer ones come first, and of two the left one.
    # ? three-not-two: return found[:2] if len(found) == 3 else found
    # ? three-not-two: return found + found[2:] if len(found) == 3 else found
    # : Where the circles touch from outside the one inner tangent comes twice, as if there were always four.


def turned(cx1, cy1, r1, cx2, cy2, r2):
    "right"
    v = complex(cx2 - cx1, cy2 - cy1)
    d = abs(v)
    near = 1e-10 * max(r1, r2, d)
    if d < abs(r1 - r2) - near:
        return []
    # ? sqrt-of-negative: pass
    # : The angle is asked for before anybody has looked whether there is a tangent: inside its cosine is more
    # : than 1. Decide first.
    u = v / d * r1
    if d <= abs(r1 - r2) + near:
        s = 1 if r1 > r2 else -1
        return [(cx1 + s * u.real, cy1 + s * u.imag)]
        # ? inner-missed: return []
    angles = [acos((r1 - r2) / d)]
    angles += [acos((r1 + r2) / d)] if d > r1 + r2 + near else []
    # ? inner-first: angles = [acos((r1 + r2) / d)] * (d > r1 + r2 + near) + angles
    points = [u * exp(side * 1j * angle) for angle in angles for side in (1, -1)]
    # ? degrees-for-radians: points = [u * exp(side * 1j * degrees(angle)) for angle in angles for side in (1, -1)]
    if abs(d - r1 - r2) <= near:
        points.append(u)
    return [(cx1 + p.real, cy1 + p.imag) for p in points]


def homothety(cx1, cy1, r1, cx2, cy2, r2):
    "equal-radii-divided"
    dx, dy = cx2 - cx1, cy2 - cy1
    d = hypot(dx, dy)
    near = 1e-10 * max(r1, r2, d)
    found = []
    for q in (r1 - r2, r1 + r2):
        if d < abs(q) - near:
            continue
        # + equal-radii-divided: if q == 0: continue
        # : Equal radii get no outer tangents, because these meet nowhere. Take their unit normal: n·v = 0.
        away = r1 * d / q
        foot = r1 * r1 / away
        if d <= abs(q) + near:
            found.append((cx1 + foot * dx / d, cy1 + foot * dy / d))
            continue
        half = sqrt((r1 - foot) * (r1 + foot))
        found += [(cx1 + (foot * dx - h * dy) / d, cy1 + (foot * dy + h * dx) / d) for h in (half, -half)]
    return found
