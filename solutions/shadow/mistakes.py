"""How a shadow goes wrong: right ways to it, and mistakes beside the lines that they spoil."""

from array import array
from math import hypot, sqrt


def single(x):
    return array("f", [x])[0]


def hair(circles, O, D, L):
    "right"
    # + diameter-for-radius: circles = [(x, y, r / 2) for x, y, r in circles]
    # @ `circles` is a list of 1 to 32 circles `(x, y, r)`
    # + swapped-coordinates: circles = [(y, x, r) for x, y, r in circles]
    # : The circles' x and y are exchanged, those of O, D and L are not.
    # + single-precision: circles = [tuple(map(single, circle)) for circle in circles]
    (ox, oy), (dx, dy), (lx, ly) = O, D, L
    # ? target-for-direction: (ox, oy), (dx, dy), (lx, ly) = O, (D[0] - O[0], D[1] - O[1]), L
    # ? direction-for-light: (ox, oy), (dx, dy), (lx, ly) = O, D, (O[0] + L[0], O[1] + L[1])
    size = max(abs(lx - ox), abs(ly - oy), *(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles))
    least = 1e-9 * size
    # = least = 3e-8 * size
    # ? acne: least = 0
    # ? absolute-t-min: least = {1e-9..1e-3/6}
    # ? fat-t-min: least = 1e-1 * size
    # ? wide-t-min: least = 1e-4 * size
    # ? direction-epsilon: least = {1e-7..1e-6/1} * max(size, abs(D[0]), abs(D[1]))
    slack = 0
    # ? loose-epsilon: slack = 1e-4 * size
    # ? loose-epsilon: slack = -1e-3 * size
    length = hypot(dx, dy) or 1e-300
    ux, uy = dx / length, dy / length
    best = None
    for index, (x, y, r) in enumerate(circles):
        fx, fy = ox - x, oy - y
        # ? forgotten-centre: fx, fy = ox, oy
        d = abs(ux * fy - uy * fx)
        foot = -(fx * ux + fy * uy)
        # + centre-behind: if foot < 0: continue
        if d >= r:
            continue
        # ? sqrt-of-negative: pass
        half = sqrt((r - d) * (r + d))
        for s in (foot - half, foot + half):
            if s > 0 and (best is None or s < best[0]):
                best = s, index
        # ? far-root: best = (foot + half, index) if foot + half > 0 and (best is None or foot + half < best[0]) else best
        # ? first-in-the-list: best = (foot - half if foot > half else foot + half, index) if foot + half > 0 and best is None else best
        # ? inside-is-miss: best = (foot - half, index) if foot - half > 0 and (best is None or foot - half < best[0]) else best
        # @ from inside, the ray hits it too
    # + segment-for-ray: if best and best[0] > length: best = None
    if best is None:
        return None
        # ? sentinel-miss: return "dark"
        # @ Return `None`
        # ? sentinel-miss: return "lit"
    s, own = best
    cx, cy, _ = circles[own]
    nx, ny = ox - cx + s * ux, oy - cy + s * uy
    # ? global-frame: nx, ny = (ox + s * ux) - cx, (oy + s * uy) - cy
    # ? from-the-origin: nx, ny = ox - cx, oy - cy
    vx, vy = (lx - cx) - nx, (ly - cy) - ny
    if (ux * nx + uy * ny < 0) != (vx * nx + vy * ny > 0):
        return "dark"
    # ? back-lit@skip: pass
    # @ on the side that the ray sees
    # ? absolute-epsilon: if (ux * nx + uy * ny) * (vx * nx + vy * ny) > {1e-9..1e-6/3}: return "dark"
    # ? inside-always-dark: if vx * nx + vy * ny < 0: return "dark"
    # ? side-swapped: if (ux * nx + uy * ny < 0) == (vx * nx + vy * ny > 0): return "dark"
    reach = hypot(vx, vy) or 1e-300
    wx, wy = vx / reach, vy / reach
    for index, (x, y, r) in enumerate(circles):
        fx, fy = nx + (cx - x), ny + (cy - y)
        # + own-wall-ignored: if index == own: continue
        # @ also the one that is hit
        # + back-lit@skip: if index == own: continue
        # + first-circle-only: if index: continue
        # @ Every circle counts
        # + ray-for-segment@all: reach = float("inf")
        # + both-ends-out: if min(hypot(fx, fy), hypot(fx + vx, fy + vy)) >= r - least: continue
        # @ beyond L, behind P
        # + blocked-by-behind@own: if index == own: continue
        d = abs(wx * fy - wy * fx)
        if d >= r + slack:
            continue
        foot, half = -(fx * wx + fy * wy), sqrt(max(0.0, (r - d) * (r + d)))
        if least < foot - half < reach or least < foot + half < reach:
            return "dark"
            # ? always-lit: return "lit"
            # ? words-swapped: return "lit"
        # ? near-root-only: if least < foot - half < reach: return "dark"
        # ? blocked-by-behind@own: if foot - half < reach: return "dark"
        # ? inside-is-blocked: if foot + half > least and foot - half < reach: return "dark"
        # @ around both P and L
    return "lit"
    # ? always-dark: return "dark"
    # @ Otherwise return `"lit"`


def moved_off(circles, O, D, L):
    "right"
    a = hypot(*D) or 1e-300
    e = max(abs(L[0] - O[0]), abs(L[1] - O[1]), *(max(r, abs(x - O[0]), abs(y - O[1])) for x, y, r in circles))
    hits = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        k = (D[0] * fy - D[1] * fx) / a
        if abs(k) < r:
            m, h = -(fx * D[0] + fy * D[1]) / a, sqrt((r - k) * (r + k))
            hits += [(s, x, y, r) for s in (m - h, m + h) if s > 0]
    if not hits:
        return None
    s, x, y, r = min(hits)
    gx, gy = (O[0] - x + s * D[0] / a) / r, (O[1] - y + s * D[1] / a) / r
    side = 1 if gx * D[0] + gy * D[1] < 0 else -1
    px, py = gx * r, gy * r
    qx, qy = L[0] - x, L[1] - y
    if side * (gx * (qx - px) + gy * (qy - py)) < 0:
        return "dark"
    # ? step-for-side: pass
    off = 1e-9 * e
    # ? acne: off = 0
    # ? absolute-t-min: off = 1e-4
    # ? fat-t-min: off = 0.01 * e
    px, py = px + side * off * gx, py + side * off * gy
    for cx, cy, radius in circles:
        hx, hy = x - cx, y - cy
        ax, ay, bx, by = px + hx, py + hy, qx + hx, qy + hy
        inner, outer = hypot(ax, ay) < radius, hypot(bx, by) < radius
        if inner != outer:
            return "dark"
        wx, wy = bx - ax, by - ay
        along = -(ax * wx + ay * wy)
        if not inner and 0 < along < wx * wx + wy * wy and abs(wx * ay - wy * ax) < radius * hypot(wx, wy):
            return "dark"
        # ? ray-for-segment: if not inner and 0 < along and abs(wx * ay - wy * ax) < radius * hypot(wx, wy): return "dark"
    return "lit"


def slope(circles, O, D, L):
    "slope-intercept"
    def roots(x, y, r, p, way):
        m = way[1] / way[0]
        n = p[1] - y - m * (p[0] - x)
        disc = r * r * (1 + m * m) - n * n
        if disc < 0:
            return []
        xs = [(-m * n - sqrt(disc)) / (1 + m * m), (-m * n + sqrt(disc)) / (1 + m * m)]
        return [(each + x - p[0]) / (way[0] or 1e-9) for each in xs]
    hits = [(t, c) for c in circles for t in roots(*c, O, D) if t > 0]
    if not hits:
        return None
    t, (x, y, r) = min(hits)
    p = O[0] + t * D[0], O[1] + t * D[1]
    way = L[0] - p[0], L[1] - p[1]
    faces = way[0] * (p[0] - x) + way[1] * (p[1] - y) > 0
    if (D[0] * (p[0] - x) + D[1] * (p[1] - y) < 0) != faces:
        return "dark"
    return "dark" if any(1e-7 < s < 1 for c in circles for s in roots(*c, p, way)) else "lit"
