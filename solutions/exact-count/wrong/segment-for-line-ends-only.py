"""segment-for-line

Only the ends are looked at: one inside and one outside make one point, and two inside none. The question is
about the infinite line.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    powers = [(x - cx) ** 2 + (y - cy) ** 2 - r * r for x, y in (A, B)]
    if max(powers) < 0:
        return 0
    if min(powers) < 0:
        return 1
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
