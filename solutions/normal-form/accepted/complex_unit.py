"""complex unit

Multiplying by i turns to the left. The part of A along the unit normal is the real part of A·conj(n).
"""


def normal_form(A, B):
    step = complex(B[0] - A[0], B[1] - A[1])
    if not step:
        return None
    normal = 1j * step / abs(step)
    away = (complex(*A) * normal.conjugate()).real
    return normal.real, normal.imag, -away
