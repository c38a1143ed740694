"""How a silhouette goes on flickering: right ways through its frames, and mistakes beside the lines they spoil."""

from math import hypot, sqrt


def machine(circles, O, D, h):
    "right"
    dx, dy = D
    # ? target-for-direction: dx, dy = D[0] - O[0], D[1] - O[1]
    # : D is taken for a point, and O is subtracted from it. It is the direction itself.
    length = hypot(dx, dy) or 1.0
    # = length = sqrt(dx * dx + dy * dy) or 1.0
    # ? direction-not-normalised: length = 1.0
    shown, answer, before = None, [], None
    # ? starts-at-one@s: shown, answer, before = True, [], None
    first_radius = circles[0][2]
    for x, y, r in circles:
        fx, fy = O[0] - x, O[1] - y
        # ? swapped-coordinates: fx, fy = O[0] - y, O[1] - x
        # ? forgotten-centre: fx, fy = O
        # @ a circle `(x, y, r)` for each frame
        # ? forgotten-centre: fx, fy = O[0] - circles[0][0], O[1] - circles[0][1]
        # : The centre of the first frame is used in all of them. Each frame has its own.
        # + diameter-for-radius: r = r / 2
        # + diameter-for-radius: r = 2 * r
        # : The radius is doubled, as if a half of it were given. It is the radius: use it as it is.
        side = (dx * fy - dy * fx) / length
        # ? swapped-coordinates: side = (dx * fx - dy * fy) / length
        # : The cross product is taken with x and y mixed up. It is dx·fy − dy·fx.
        # ? global-frame: side = (dx / length * O[1] - dy / length * O[0]) - (dx / length * y - dy / length * x)
        d = abs(side)
        # ? forgotten-abs: d = side
        # ? forgotten-abs: d = -side
        # ? distance-to-origin: d = hypot(fx, fy)
        # ? half-line: d = abs(side) if fx * dx + fy * dy <= 0 else hypot(fx, fy)
        # @ for every t
        # ? segment-distance: d = (lambda t: hypot(fx + t * dx, fy + t * dy))(max(0, min(1, -(fx * dx + fy * dy) / length / length)))
        # ? squared: d = side * side
        size = max(r, abs(fx), abs(fy))
        # = size = max(r, hypot(fx, fy))
        # ? coordinate-epsilon: size = max(abs(x), abs(y), r, abs(O[0]), abs(O[1]))
        # ? coordinate-epsilon: size = max(1, r, abs(fx), abs(fy))
        # : The threshold does not shrink with the figure: a small circle is all epsilon. Measure the
        # : size from the centre, and add nothing to it.
        near = 1e-10 * size
        # = near = 1e-9 * size
        # ? absolute-epsilon: near = {1e-9..1e-3/6}
        # ? tight-epsilon: near = 0
        # : A threshold is passed by any rounding where d is exactly at it. Leave 1e-9 of the size to rounding.
        # ? tight-epsilon: near = -1e-9 * size
        # : At a threshold it counts as passed. There nothing changes: the tolerance belongs to the other side.
        # ? loose-epsilon: near = {1e-4..1e-2/2} * size
        width = h * r
        # ? absolute-threshold: width = h
        # ? absolute-threshold: width = h * first_radius
        # : The thresholds are a part of the first frame's radius. They go with the radius of each frame.
        # ? half-a-threshold: width = h * r / 2
        low, high = r - width - near, r + width + near
        # ? no-hysteresis: low, high = r, r
        # ? no-hysteresis: low, high = r - width - near, r - width - near
        # : One threshold, r·(1 − h), serves both ways, and there it flickers. A hit ends beyond r·(1 + h).
        # ? one-sided-threshold: low, high = r - near, r + width + near
        # @ A frame after a 0
        # ? one-sided-threshold: low, high = r - width - near, r + near
        # @ A frame after a 1
        # : A hit ends too early or too late. It ends beyond r·(1 + h) only.
        # ? wide-both-ways: low, high = r + width + near, r - width - near
        if shown is None:
            shown = d < r
            # ? starts-at-zero: shown = d < low
            # @ The first frame shows 1
            # : The first frame is a hit only below r·(1 − h). It has nothing before it: compare d with r.
            # ? starts-at-zero: shown = False
            # ? starts-at-one: shown = True
            # ? inverted: shown = d > r
            # : The first frame alone is answered the wrong way round. It shows 1 for d < r.
            # ? zero-radius: shown = d < r or r == 0
        elif shown:
            shown = d <= high
            # ? previous-frame: shown = d <= high or before <= high
            # : One frame beyond the threshold is let pass, as if two were needed. The first one already is a miss.
        else:
            shown = d < low
            # ? previous-frame: shown = d < low and before < low
            # : A hit is shown a frame late, as if two were needed below the threshold. The first one already is a hit.
        # + previous-d: shown = d < r if before is None or abs(d - before) > width else bool(answer[-1])
        # + between-is-a-miss: shown = d < r if before is None else d < low
        # @ what the frame before it shows
        # : Whatever is not below r·(1 − h) is a miss, also after a hit. Between the thresholds nothing changes.
        # + between-is-a-miss: shown = d < r if before is None else d <= high
        # : Whatever is not above r·(1 + h) is a hit, also after a miss. Between the thresholds nothing changes.
        answer.append(int(shown))
        # ? boolean-answer: answer.append(bool(shown))
        # @ 1 for a hit, 0 for a miss
        # ? float-answer: answer.append(float(shown))
        # ? changes-only: answer.append(int(bool(answer) and shown != was))
        before, was = d, shown
    return answer
    # ? last-only: return answer[-1:]


def slopes(circles, O, D, h):
    "slope-intercept"
    # + slope-intercept: if D[0] == 0: return [0 for _ in circles]
    # : An upright line, which has no slope, is answered with misses. Work with the direction D.
    m = D[1] / D[0]
    n = O[1] - m * O[0]
    answer = []
    for x, y, r in circles:
        d = abs(m * x - y + n) / sqrt(m * m + 1)
        if not answer:
            answer.append(int(d < r))
        elif answer[-1]:
            answer.append(int(d <= r * (1 + h)))
        else:
            answer.append(int(d < r * (1 - h)))
    return answer
