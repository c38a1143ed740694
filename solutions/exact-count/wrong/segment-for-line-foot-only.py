"""segment-for-line

If the foot of the perpendicular is not between A and B, the line is said to miss. The question is about the
infinite line: the foot may be anywhere on it.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    if not 0 <= (cx - A[0]) * dx + (cy - A[1]) * dy <= dx * dx + dy * dy:
        return 0
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach = r * r * (dx * dx + dy * dy)
    if k * k == reach:
        return 1
    return 2 if k * k < reach else 0
