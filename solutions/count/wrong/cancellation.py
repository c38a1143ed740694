"""cancellation

The discriminant is b² - a·c in doubles. When A is far away both terms are huge and agree in almost
all digits, and what the circle contributes is lost. Write it as r²·a - k² with the cross product k:
the huge part is gone before anything is rounded.
"""


def line_count(cx, cy, r, A, B):
    ax, ay = float(A[0] - cx), float(A[1] - cy)
    dx, dy = float(B[0] - A[0]), float(B[1] - A[1])
    if dx == 0.0 and dy == 0.0:
        return None
    a = dx**2 + dy**2
    b = ax * dx + ay * dy
    c = ax**2 + ay**2 - r**2
    discriminant = b * b - a * c
    noise = 1e-11 * (b * b + a * (ax**2 + ay**2 + r**2))
    if discriminant > noise:
        return 2
    if discriminant < -noise:
        return 0
    return 1
