"""swapped-coordinates

The points come as (y, x).
Return (x, y).
"""


def circle_segment(cx, cy, r, A, B):
    start, end = complex(A[1] - cy, A[0] - cx), complex(B[1] - cy, B[0] - cx)
    near = 1e-10 * max(r, abs(start.real), abs(start.imag), abs(end.real), abs(end.imag))
    if start == end:
        return [A] if abs(abs(start) - r) <= near else []
    length = abs(end - start)
    unit = (end - start) / length
    turned = start / unit
    room = r - abs(turned.imag)
    if room < -near:
        return []
    half = (room * (r + abs(turned.imag))) ** 0.5 if room > near else 0.0
    found = []
    for x in sorted({-half, half}):
        if -near <= x - turned.real <= length + near:
            z = complex(x, turned.imag) * unit + complex(cy, cx)
            found.append((z.real, z.imag))
    return found
