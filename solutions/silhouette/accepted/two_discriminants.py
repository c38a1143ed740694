"""two discriminants

No root and no division: the line meets a circle of radius s where s²·a − k² is above 0, k being the cross product of D
and O − C, and a = D·D. Each frame asks that of the radius which counts, a little shrunk or grown. A hit goes on where it
is 0 as well: the grown circle may be the point O, whose size is 0.
"""


def steady_hits(circles, O, D, h):
    size = max(abs(D[0]), abs(D[1]))
    dx, dy = D[0] / size, D[1] / size
    a = dx * dx + dy * dy
    answer = []
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        k = dx * fy - dy * fx
        room = 1e-10 * max(r, abs(fx), abs(fy))
        if not answer:
            shown = r * r * a > k * k
        elif answer[-1]:
            grown = r + h * r + room
            shown = grown * grown * a >= k * k
        else:
            shrunk = r - h * r - room
            shown = shrunk > 0 and shrunk * shrunk * a > k * k
        answer.append(1 if shown else 0)
    return answer
