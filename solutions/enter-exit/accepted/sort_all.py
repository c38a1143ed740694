"""sort them all

Each circle gives two hits, one touch or none; all of them in one list, sorted by t.

From C the ray's line passes at the distance d = |D × f|/|D|, f = O − C, and the foot of the perpendicular is −(f·D)/|D|
along it. |d − r| within 1e-10 of the size is a touch; otherwise half of the chord, √((r − d)(r + d)), is the way back
to where the ray comes in and forth to where it leaves. The tag goes with the hit before anything is sorted.
"""

from math import hypot, sqrt


def all_hits(circles, O, D):
    (ox, oy), (dx, dy) = O, D
    size = max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    near = 1e-10 * size
    length = hypot(dx, dy)
    ux, uy = dx / length, dy / length
    hits = []
    for index, (x, y, r) in enumerate(circles):
        fx, fy = ox - x, oy - y
        d = abs(ux * fy - uy * fx)
        foot = -(fx * ux + fy * uy)
        if d > r + near:
            continue
        if d >= r - near:
            found = [(foot, "touch")]
        else:
            half = sqrt((r - d) * (r + d))
            found = [(foot - half, "enter"), (foot + half, "exit")]
        hits += [(max(s, 0.0) / length, index, tag) for s, tag in found if s >= -near]
    hits.sort(key=lambda hit: hit[0])
    return hits
