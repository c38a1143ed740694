"""turned frame

Complex numbers, turned so that the motion seen from the second disc runs along the real axis. The imaginary part is
how far it passes by, and the real part is time.
"""


def balls_meet(P0, P1, r, Q0, Q1, s):
    p, p_end, q, q_end = (complex(*z) for z in (P0, P1, Q0, Q1))
    reach = r + s
    sizes = [reach] + [part for z in (p_end - p, q - p, q_end - p) for part in (abs(z.real), abs(z.imag))]
    slack = max(sizes) * 1e-10
    if abs(p - q) - reach <= slack:
        return 0
    way = (p_end - p) - (q_end - q)
    if way == 0:
        return None
    speed = abs(way)
    place = (p - q) * (way / speed).conjugate()
    height = abs(place.imag)
    if height - reach > slack:
        return None
    back = 0 if reach - height <= slack else ((reach - height) * (reach + height)) ** 0.5
    time = -(place.real + back)
    return time / speed if 0 <= time <= speed + slack else None
