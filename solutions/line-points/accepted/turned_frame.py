"""turned frame

In the complex plane, divided by the direction of the line: there it is level, the points have its height, and their
order is that of their real parts. Then they are turned back.
"""


def line_points(cx, cy, r, A, B):
    step = complex(B[0] - A[0], B[1] - A[1])
    if step == 0:
        return None
    unit = step / abs(step)
    start, end = complex(A[0] - cx, A[1] - cy), complex(B[0] - cx, B[1] - cy)
    height = (start * unit.conjugate()).imag
    room = 1e-10 * max(r, abs(start), abs(end))
    if abs(height) > r + room:
        return []
    touches = abs(height) >= r - room
    half = 0.0 if touches else ((r - height) * (r + height)) ** 0.5
    places = [0.0] if touches else [-half, half]
    turned = [complex(x, height) * unit for x in places]
    return [(cx + point.real, cy + point.imag) for point in turned]
