"""complex plane

The segment is turned onto the real axis by a complex number; there the circle meets it at x ± half-chord.
"""


def circle_segment(cx, cy, r, A, B):
    centre = complex(cx, cy)
    start = complex(A[0] - cx, A[1] - cy)
    step = complex(B[0] - A[0], B[1] - A[1])
    finish = complex(B[0] - cx, B[1] - cy)
    size = max(r, abs(start.real), abs(start.imag), abs(finish.real), abs(finish.imag))
    slack = 1e-10 * size

    if step == 0:
        on_circle = abs(abs(start) - r) <= slack
        return [(A[0], A[1])] if on_circle else []

    length = abs(step)
    unit = step / length
    turned = start * unit.conjugate()  # the line is now horizontal, at this height
    height = abs(turned.imag)
    if height - r > slack:
        return []
    half = 0.0 if r - height <= slack else ((r - height) * (r + height)) ** 0.5

    found = []
    for x in sorted({-half, half}):
        if turned.real - slack <= x <= turned.real + length + slack:
            point = centre + complex(x, turned.imag) * unit
            found.append((point.real, point.imag))
    return found
