"""segment-for-line

The distance is that of the nearest point between A and B. The question is about the infinite line: only the
cross product matters.
"""

def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    a, b = dx * dx + dy * dy, fx * dx + fy * dy
    k = dx * fy - dy * fx
    if b >= 0:
        square = (fx * fx + fy * fy) * a
    elif -b >= a:
        square = ((fx + dx) ** 2 + (fy + dy) ** 2) * a
    else:
        square = k * k
    if square == r * r * a:
        return 1
    return 2 if square < r * r * a else 0
