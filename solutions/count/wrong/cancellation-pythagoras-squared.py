"""cancellation

The squared distance is |f|² − (f·D)²/a, a difference of two large numbers when A is far away, compared with
r² as it is. The cross product gives k²/a without a difference.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = dx * dx + dy * dy
    dd = float(fx) ** 2 + float(fy) ** 2 - (float(fx) * dx + float(fy) * dy) ** 2 / a
    if abs(dd - r * r) <= 1e-10 * e * (r + 1e-10 * e):
        return 1
    return 2 if dd < r * r else 0
