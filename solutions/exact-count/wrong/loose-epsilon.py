"""loose-epsilon

Whatever agrees to nine digits is called a tangent. Here there is no tolerance at all: compare with
==, in ints.
"""


def exact_count(cx, cy, r, A, B):
    dx, dy = B[0] - A[0], B[1] - A[1]
    if not (dx or dy):
        return None
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    reach, distance = r * r * (dx * dx + dy * dy), k * k
    if abs(reach - distance) * 10**9 <= max(reach, distance):
        return 1
    return 2 if distance < reach else 0
