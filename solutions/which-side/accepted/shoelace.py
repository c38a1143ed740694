"""shoelace

The area of the triangle A, B, P by the shoelace formula, from the three points as they are. It is above 0 where they
go round to the left.
"""


def which_side(A, B, P):
    corners = [A, B, P]
    twice = 0
    for (x1, y1), (x2, y2) in zip(corners, [B, P, A]):
        twice += x1 * y2 - x2 * y1
    return (twice > 0) - (twice < 0)
