"""stretches

What so many hops reach is a stretch; the next one ends where its farthest hop ends.
"""


def hops(reach):
    count = here = far = 0
    for at, each in enumerate(reach):
        if at > far:
            return None
        if at > here:
            count, here = count + 1, far
        far = max(far, at + each)
    return count
