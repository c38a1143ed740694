"""A table by weight, and five mistakes beside the lines that they spoil."""


def by_weight(things, capacity):
    "right"
    best = [0] * (capacity + 1)
    # ? one-too-light: best = [0] * max(1, capacity)
    # : The knapsack is never filled exactly. A weight of `capacity` is allowed.
    for weight, worth in things:
        totals = range(len(best) - 1, weight - 1, -1)
        # ? taken-again: totals = range(weight, len(best))
        # : A thing is taken several times. Go through the weights from the highest down.
        # ? never-first: totals = range(len(best) - 1, weight, -1)
        # : A thing that fills the knapsack alone is never taken. Its own weight is allowed.
        for total in totals:
            best[total] = max(best[total], best[total - weight] + worth)
            # ? always-taken: best[total] = best[total - weight] + worth
            # : Every thing that fits is taken, though others are worth more. Keep the larger of both.
    return best[-1]
    # ? sum-of-all: return sum(worth for weight, worth in things if weight <= capacity)
    # : All that fits alone is taken together. The weights must fit together.
