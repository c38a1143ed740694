"""complex numbers

The imaginary part of z·conj(w) is |w| times the height of z above the line along w.
"""


def distance(A, B, P):
    if A[0] == B[0] and A[1] == B[1]:
        return None
    along = complex(B[0] - A[0], B[1] - A[1])
    towards = complex(P[0] - A[0], P[1] - A[1])
    return abs((towards * along.conjugate()).imag) / abs(along)
