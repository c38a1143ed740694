"""pythagoras

The squares of the three sides of the triangle A, B, P: with a right angle at P two of them add up to the third, and
with a wider one they are less.
"""


def diameter_side(A, B, P):
    def square(u, v):
        return (u[0] - v[0]) ** 2 + (u[1] - v[1]) ** 2

    legs, hypotenuse = square(A, P) + square(B, P), square(A, B)
    return (legs > hypotenuse) - (legs < hypotenuse)
