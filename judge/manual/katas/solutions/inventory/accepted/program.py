"""program"""

import sys


def main():
    words = iter(sys.stdin.read().split())
    for _ in range(int(next(words))):
        stock = {}
        for _ in range(int(next(words))):
            thing = next(words)
            stock[thing] = int(next(words))
        for _ in range(int(next(words))):
            thing, count = next(words), int(next(words))
            left = stock.get(thing, 0) + count
            if left >= 0:
                stock[thing] = left
        left = {thing: count for thing, count in stock.items() if count}
        print(len(left), *(f"{thing} {count}" for thing, count in left.items()))


main()
