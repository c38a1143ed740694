"""counter"""

from collections import Counter


def inventory(stock, moves):
    left = Counter(stock)
    for thing, count in moves:
        if left[thing] + count >= 0:
            left[thing] += count
    return +left
