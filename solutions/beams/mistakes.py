"""How a scan goes wrong: a right sweep and a right loop, with mistakes beside the lines."""

from bisect import insort
from math import asin, atan, atan2, degrees, hypot, inf, pi, sqrt
from operator import itemgetter


def sweep(circles, O, dirs):
    "right"
    ox, oy = O
    near = 1e-10 * max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    events = []
    for i, (x, y, r) in enumerate(circles):
        fx, fy = x - ox, y - oy
        middle, half = atan2(fy, fx), asin(min(1.0, r / hypot(fx, fy))) + 1e-6
        # ? angle-by-slope@atan: middle, half = atan(fy / fx) if fx else pi / 2, asin(min(1.0, r / hypot(fx, fy))) + 1e-6
        # @ The directions are sorted by angle
        # ? half-interval: middle, half = atan2(fy, fx), asin(min(1.0, r / hypot(fx, fy))) / 2
        # ? tangent-of-centre: middle, half = atan2(fy, fx), atan(r / hypot(fx, fy))
        turns = (-2 * pi, 0.0, 2 * pi)
        # ? wrap-around-lost: turns = (0.0,)
        for turn in turns:
            events.append((middle + turn - half, middle + turn + half, hypot(fx, fy) - r, fx, fy, r, i))
    events.sort()
    inside, begun, answers = [], 0, []
    last = None
    for dx, dy in dirs:
        angle = atan2(dy, dx)
        # ? degrees-for-radians: angle = degrees(atan2(dy, dx))
        # ? angle-by-slope@atan: angle = atan(dy / dx) if dx else pi / 2
        length = hypot(dx, dy)
        while begun < len(events) and events[begun][0] <= angle:
            insort(inside, events[begun], key=itemgetter(2))
            begun += 1
        inside = [each for each in inside if each[1] >= angle]
        best, found = inf, None
        for _, _, least, fx, fy, r, i in inside:
            if least > best: break
            d = abs(dx * fy - dy * fx) / length
            middle = (dx * fx + dy * fy) / length
            if d > r + near: continue
            if middle < 0: continue
            # ? angle-by-slope@atan: pass
            s = middle - (sqrt((r - d) * (r + d)) if d < r - near else 0.0)
            # + stale-candidates: if i == last: best, found = s, i; break
            if s < best: best, found = s, i
        last = found
        answers.append(None if found is None else (found, best / length))
    return answers


def loop(circles, O, dirs):
    "right"
    ox, oy = O
    # + swapped-coordinates: circles = [(y, x, r) for x, y, r in circles]
    # + swapped-coordinates: ox, oy = oy, ox
    # + diameter-for-radius: circles = [(x, y, 2 * r) for x, y, r in circles]
    # @ `circles` is a list of `(x, y, r)`
    near = 1e-10 * max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    # ? loose-epsilon: near = 1e-5 * max(max(r, abs(x - ox), abs(y - oy)) for x, y, r in circles)
    answers = []
    last = None
    for dx, dy in dirs:
        length = hypot(dx, dy)
        best, found, at = inf, None, 0.0
        order = range(len(circles))
        # ? stale-candidates: order = range(len(circles)) if last is None else (last,)
        # : Only the circle of the beam before is asked, as long as there is one.
        for i in order:
            x, y, r = circles[i]
            fx, fy = x - ox, y - oy
            # ? forgotten-start: fx, fy = x, y
            d = abs(dx * fy - dy * fx) / length
            # ? not-divided: d = abs(dx * fy - dy * fx)
            # @ is a list of directions
            # ? angle-by-slope: d = abs(dy / dx * fx - fy) / sqrt(1 + (dy / dx) ** 2) if dx else abs(fx)
            # | fx, fy = (fx, fy) if dx * fx + dy * fy > 0 else (-fx, -fy)
            if d > r + near: continue
            # ? tangent-missed: if d >= r - near: continue
            middle = (dx * fx + dy * fy) / length
            if middle < 0: continue
            # ? line-for-ray: middle = abs(middle)
            # @ What lies behind O
            # : A circle behind O is met at |t|.
            half = sqrt((r - d) * (r + d)) if d < r - near else 0.0
            # + foot-for-root: half = 0.0
            s = middle - half
            # + segment-for-ray: if s > length: continue
            # ? far-root: s = middle + half
            key = s
            # ? index-of-centre-distance: key = hypot(fx, fy)
            # ? index-of-centre-distance: key = hypot(fx, fy) - r
            # : The circle whose disc is nearest to O is taken, and not the one that is met first.
            if key < best: best, found, at = key, i, s
            # = if key <= best: best, found, at = key, i, s
            # ? first-index: best, found, at = (key, i, s) if found is None else (best, found, at)
            # @ is met first
            # ? farthest-seen: best, found, at = (key, i, s) if found is None or key > best else (best, found, at)
        last = found
        answers.append(None if found is None else (found, at / length))
        # ? distance-for-parameter: answers.append(None if found is None else (found, at))
        # @ t is the parameter
        # ? rounded-parameter: answers.append(None if found is None else (found, round(at / length, 6)))
        # ? one-based: answers.append(None if found is None else (found + 1, at / length))
        # @ Indices count from 0
        # ? sentinel-miss: answers.append((-1, -1.0) if found is None else (found, at / length))
    return answers
    # ? misses-left-out: return [each for each in answers if each is not None]
    # @ Return a list with one element
