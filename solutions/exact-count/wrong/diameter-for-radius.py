"""diameter-for-radius

The radius is treated as a diameter: 4·k² is compared with r²·a. The third argument is the radius.
"""


def exact_count(cx, cy, diameter, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if not dx and not dy:
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    left, right = 4 * k * k, diameter**2 * (dx**2 + dy**2)
    return 1 if left == right else 2 if left < right else 0
