"""kept-between-calls

What was shown last lives outside of the function, so that a call goes on where the one before it ended. Begin each
call afresh.
"""

from math import hypot

shown = None


def steady_hits(circles, O, D, h):
    global shown
    answer = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        d = abs(D[0] * fy - D[1] * fx) / hypot(*D)
        near = 1e-10 * max(r, abs(fx), abs(fy))
        if shown is None:
            shown = d < r
        else:
            shown = d <= r * (1 + h) + near if shown else d < r * (1 - h) - near
        answer.append(int(shown))
    return answer
