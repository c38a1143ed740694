"""global-frame

x² and y² of the points and of the centre are expanded and added up: far from the origin they are 1e17 and
more, and the radius is lost in them. Subtract the centre first, then multiply.
"""

def line_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 and dy == 0:
        return None
    fx, fy = A[0] - cx, A[1] - cy
    e = max(r, abs(fx), abs(fy), abs(B[0] - cx), abs(B[1] - cy))
    a = float(dx) ** 2 + float(dy) ** 2
    x, y = float(A[0]), float(A[1])
    b = (x * dx + y * dy) - (cx * dx + cy * dy)
    c = x * x + y * y + float(cx) ** 2 + float(cy) ** 2 - 2 * (x * cx + y * cy) - r * r
    delta = b * b - a * c
    if abs(delta) <= 2e-10 * e * a * (r + e * 1e-10):
        return 1
    return 2 if delta > 0 else 0
