"""quadratic-equation

A point of the line is A + t·(B - A), and it is on the circle where |A + t·(B - A) - C|² = r². That is a quadratic
equation in t with whole coefficients, and the sign of its discriminant says how many solutions there are.
"""


def crossings(cx, cy, r, A, B):
    (ax, ay), (bx, by) = A, B
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    a = dx**2 + dy**2
    b = 2 * (fx * dx + fy * dy)
    c = fx**2 + fy**2 - r**2
    discriminant = b * b - 4 * a * c
    return 1 + (discriminant > 0) - (discriminant < 0)
