"""two equations

F lies on the line, D × (F − A) = 0, and straight below C, D·(F − C) = 0: two equations with two unknowns,
solved by Cramer's rule as seen from C; then t by the longer coordinate of D.
"""


def foot(A, B, C):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if dx == 0 == dy:
        return None
    ax, ay = A[0] - C[0], A[1] - C[1]
    # dx·x + dy·y = 0 and dx·y − dy·x = cross
    cross = dx * ay - dy * ax
    determinant = dx * dx + dy * dy
    x, y = -dy * cross / determinant, dx * cross / determinant
    t = (x - ax) / dx if abs(dx) > abs(dy) else (y - ay) / dy
    return t, (C[0] + x, C[1] + y)
