"""program

A whole program: T on the first line, then a case a line. The ray is turned onto the x axis by complex numbers.
"""

import sys


def answer(numbers):
    n = int(numbers[0])
    values = list(map(float, numbers[1:]))
    ox, oy, dx, dy = values[3 * n :]
    way = complex(dx, dy)
    length = abs(way)
    turn = way.conjugate() / length
    circles = [(values[i] - ox, values[i + 1] - oy, values[i + 2]) for i in range(0, 3 * n, 3)]
    eps = 1e-10 * max(max(abs(x), abs(y), r) for x, y, r in circles)
    hits = []
    for index, (x, y, r) in enumerate(circles):
        centre = complex(x, y) * turn
        gap = r - abs(centre.imag)
        if abs(gap) <= eps:
            hits.append((centre.real, index, "touch"))
        elif gap > 0:
            half = (gap * (r + abs(centre.imag))) ** 0.5
            hits.append((centre.real - half, index, "enter"))
            hits.append((centre.real + half, index, "exit"))
    hits = sorted((max(x, 0.0) / length, index, tag) for x, index, tag in hits if x >= -eps)
    return " ".join([str(len(hits)), *(f"{t!r} {index} {tag}" for t, index, tag in hits)])


def main():
    lines = sys.stdin.read().splitlines()
    print("\n".join(answer(line.split()) for line in lines[1 : 1 + int(lines[0])]))


main()
