"""How the foot on a horizontal or vertical line goes wrong: right ways to it, and mistakes beside the lines they spoil."""


def wrap(x):
    return (x + (1 << 31)) % (1 << 32) - (1 << 31)


def coordinates(A, B, P):
    "right"
    # + point-unmoved: return P
    # + end-for-foot: return A
    # @ foot of the perpendicular
    # + end-for-foot: return B
    # : B is returned, wherever P is. Take one coordinate from P.
    # + always-level: return (P[0], A[1])
    # @ horizontal or vertical
    # + always-level: return (A[0], P[1])
    # : Every line is taken for an upright one. If A and B have the same y it is level.
    # + other-axis: return (A[0], P[1]) if A[1] == B[1] else (P[0], A[1])
    # + clamp-to-ends: P = tuple(max(min(a, b), min(max(a, b), p)) for a, b, p in zip(A, B, P))
    # @ need not be between A and B
    # + forgotten-start: return (P[0], 0) if A[1] == B[1] else (0, P[1])
    # : The line is taken to run through (0, 0). Take its y, or its x, from A.
    if A[1] == B[1]:
        return (P[0], A[1])
        # = return (P[0], B[1])
        # ? swapped-coordinates@swap: return (A[1], P[0])
        # ? mirror-for-foot@mirror: return (P[0], 2 * A[1] - P[1])
        # ? distance-for-point@far: return abs(P[1] - A[1])
        # ? float-answer@float: return (float(P[0]), float(A[1]))
        # ? distance-for-point@pair: return (0, P[1] - A[1])
        # ? clamp-to-ends: return (max(min(A[0], B[0]), min(max(A[0], B[0]), P[0])), A[1])
        # : On level lines the foot is moved to the nearer end. The line goes on beyond it.
    return (A[0], P[1])
    # = return (B[0], P[1])
    # ? swapped-coordinates@swap: return (P[1], A[0])
    # ? mirror-for-foot@mirror: return (2 * A[0] - P[0], P[1])
    # ? distance-for-point@far: return abs(P[0] - A[0])
    # ? float-answer@float: return (float(A[0]), float(P[1]))
    # ? distance-for-point@pair: return (P[0] - A[0], 0)
    # : The way from the line to P is returned. The foot is asked for: the point where that way begins.


def projection(A, B, P):
    "right"
    dx, dy = B[0] - A[0], B[1] - A[1]
    fx, fy = P[0] - A[0], P[1] - A[1]
    # ? wrong-direction: fx, fy = A[0] - P[0], A[1] - P[1]
    # ? forgotten-start: fx, fy = P
    # ? wrong-direction: fx, fy = P[0] - B[0], P[1] - B[1]
    # : The way to P begins at B, but the step is made from A. Let both begin at A.
    along = fx * dx + fy * dy
    # ? other-axis: along = fx * dy - fy * dx
    # : The cross product stands where the scalar product belongs: how far P is from the line, not how far along.
    # ? overflow-32: along = wrap(fx * dx + fy * dy)
    # @ of whole numbers
    square = dx * dx + dy * dy
    # ? undivided: square = 1
    # ? undivided: square = abs(dx) + abs(dy)
    # : The step is divided by |B - A|, and so is too long. Divide by |B - A|².
    # ? overflow-32: square = wrap(dx * dx + dy * dy) or 1
    return A[0] + along * dx // square, A[1] + along * dy // square
    # = return A[0] + round(along / square * dx), A[1] + round(along / square * dy)
    # ? floor-division: return A[0] + along // square * dx, A[1] + along // square * dy
    # ? float-arithmetic: return int(A[0] + along / square * dx), int(A[1] + along / square * dy)
    # ? forgotten-start: return along * dx // square, along * dy // square
    # : A is not added in the end: the way from A to the foot is returned. The foot is A plus that.


def slope(A, B, P):
    "slope-intercept"
    m = (B[1] - A[1]) / (B[0] - A[0])
    n = A[1] - m * A[0]
    x = (P[0] + m * (P[1] - n)) / (m * m + 1)
    return round(x), round(m * x + n)


def perpendicular(A, B, P):
    "slope-intercept"
    m = -(B[0] - A[0]) / (B[1] - A[1])
    return A[0], round(P[1] + m * (A[0] - P[0]))
