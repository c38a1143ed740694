"""by weight

For each weight up to the capacity it keeps the most that is worth, one thing after another, from the highest weight down.
"""


def knapsack(things, capacity):
    best = [0] * (capacity + 1)
    for weight, worth in things:
        for total in range(capacity, weight - 1, -1):
            best[total] = max(best[total], best[total - weight] + worth)
    return best[capacity]
