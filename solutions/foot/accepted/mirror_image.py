"""mirror image

In the complex plane: dividing by B − A turns the line onto the real axis, where the mirror image is the
conjugate. The foot is the middle between a point and its mirror image, that is its real part.
"""


def foot(A, B, C):
    step = complex(B[0] - A[0], B[1] - A[1])
    if step == 0:
        return None
    turned = complex(C[0] - A[0], C[1] - A[1]) / step
    middle = (turned + turned.conjugate()) / 2
    moved = middle * step
    return middle.real, (A[0] + moved.real, A[1] + moved.imag)
