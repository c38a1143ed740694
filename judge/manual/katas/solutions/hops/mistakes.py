"""Stretches, and five mistakes beside the lines that they spoil."""


def stretches(reach):
    "right"
    count = here = far = 0
    for at, each in enumerate(reach):
        if at > far:
            return None
            # ? minus-one-for-none: return -1
            # : Where there is no way, -1 is returned. Return None.
        if at > here:
            count, here = count + 1, far
            # ? one-stone-a-hop: count, here = count + 1, at
            # : A hop counts for each stone. It may pass several.
        far = max(far, at + each)
        # ? last-reach: far = at + each
        # : The reach of an earlier stone is forgotten. Keep the farthest.
        # ? one-too-far: far = max(far, at + each + 1)
        # : Each hop is one stone longer than it may be.
    return count
    # ? first-counts: return count + 1
    # : The first stone counts as a hop. Nobody hops to it.
