"""How a sign goes wrong: right ways to it, and mistakes beside the lines that they spoil."""

from decimal import Decimal, localcontext


def exact(cx, cy, r, ax, ay, bx, by):
    ratios = [x.as_integer_ratio() for x in (cx, cy, r, ax, ay, bx, by)]
    unit = max([bottom for _, bottom in ratios])
    cx, cy, r, ax, ay, bx, by = [top * (unit // bottom) for top, bottom in ratios]
    dx, dy = bx - ax, by - ay
    k = dx * (ay - cy) - dy * (ax - cx)
    delta = r * r * (dx * dx + dy * dy) - k * k
    return (delta > 0) - (delta < 0)


def decimals(numbers, digits):
    with localcontext() as context:
        context.prec = digits
        cx, cy, r, ax, ay, bx, by = map(Decimal, numbers)
        dx, dy = bx - ax, by - ay
        delta = r * r * (dx * dx + dy * dy) - (dx * (ay - cy) - dy * (ax - cx)) ** 2
        return (delta > 0) - (delta < 0)


def filtered(cx, cy, r, ax, ay, bx, by):
    "right"
    cx, cy, r, ax, ay, bx, by = float(cx), float(cy), float(r), float(ax), float(ay), float(bx), float(by)
    dx, dy, fx, fy = bx - ax, by - ay, ax - cx, ay - cy
    # ? from-world-origin: dx, dy, fx, fy = bx - ax, by - ay, ax, ay
    # + no-degenerate: if dx == dy == 0: return -1
    # : A = B is answered with −1, as a miss. Δ is 0 then.
    # + no-degenerate: if dx == dy == 0: return None
    # : A = B is answered with None. Δ is 0 then, and so is the answer.
    p, q = dx * fy, dy * fx
    k, m = p - q, abs(p) + abs(q)
    reach = r * r * (dx * dx + dy * dy)
    delta = reach - k * k
    # ? filter-b2ac: delta = (fx * dx + fy * dy) ** 2 - (dx * dx + dy * dy) * (fx * fx + fy * fy - r * r)
    # : Δ is computed as b² − a·c, and the bound is that of r²·a − k²: far along the line b² and a·c are huge, and
    # : so are their roundings.
    # + float-sign: return (delta > 0) - (delta < 0)
    # @ **exact** one
    # + swapped-answers: delta = -delta
    # + absolute-filter: return 0 if abs(delta) <= 1e-9 else 1 if delta > 0 else -1
    # + tolerance: return 0 if abs(delta) <= 1e-11 * reach else 1 if delta > 0 else -1
    # + tolerance: return 0 if abs(delta) <= 1e-15 * (reach + m * abs(k)) + 1e-30 * m * m else 1 if delta > 0 else -1
    # : What a bound of the rounding does not decide is called a touch. It is one only if Δ is 0.
    # + decimal-28: return decimals((cx, cy, r, ax, ay, bx, by), 28)
    # + boolean-answer: return delta >= 0
    # + segment-for-line: if not 0 <= -(fx * dx + fy * dy) <= dx * dx + dy * dy: return -1
    # @ the line runs through A
    # : A foot that is not between A and B is taken for a miss. The question is about the infinite line.
    bound = 1.2e-16 * (16 * reach + 18 * m * abs(k)) + 1.3e-30 * m * m
    # = bound = 4e-15 * (reach + m * abs(k)) + 4e-30 * m * m
    # ? constant-bound: bound = 1e-9
    # ? no-square: bound = 1.2e-16 * (16 * reach + 18 * m * abs(k))
    # ? unsound-bound: bound = 1e-12 * abs(delta)
    # ? ignores-input-rounding: bound = 1.2e-16 * (4 * reach + 4 * k * k)
    # : The bound is smaller than what rounding can do. dx, dy, fx and fy are rounded already, which is large beside k
    # : where dx·fy and dy·fx cancel.
    # + trusted-zero: if delta == 0: return 0
    if delta > bound:
        return 1
    if delta < -bound:
        return -1
    return exact(cx, cy, r, ax, ay, bx, by)
    # ? decimal-28: return decimals((cx, cy, r, ax, ay, bx, by), 50)
    # : The exact way is decimals of 50 digits; four doubles have 64 and more between them.
