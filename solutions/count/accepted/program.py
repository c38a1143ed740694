"""program-with-complex-numbers

Reads the cases from standard input. Dividing by B - A turns the line until it is horizontal: what
is left of A is its height above the centre, and its imaginary part is the distance.
"""

import sys


def number(token):
    return int(token) if token.lstrip("+-").isdigit() else float(token)


def answer(cx, cy, r, ax, ay, bx, by):
    if (ax, ay) == (bx, by):
        return "none"
    a, b = complex(ax - cx, ay - cy), complex(bx - cx, by - cy)
    along = complex(bx - ax, by - ay)
    height = abs((a * along.conjugate()).imag) / abs(along)
    size = max(r, abs(a), abs(b))
    if abs(height - r) <= 5e-11 * size:
        return "1"
    return "2" if height < r else "0"


def main():
    lines = sys.stdin.read().splitlines()
    for line in lines[1 : int(lines[0]) + 1]:
        print(answer(*map(number, line.split())))


main()
