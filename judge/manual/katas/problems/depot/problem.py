"""Boxes on shelves: a list of numbers is all that is kept."""

from judge.problem.declare import Format, InvalidCase, group


def solve(shelves, steps):
    boxes, answers = [0] * (shelves + 1), []
    for what, shelf, count in steps:
        if not 1 <= shelf <= shelves:
            raise InvalidCase(f"there is no shelf {shelf}")
        if (count == 0) is not (what == "ask"):
            raise InvalidCase("boxes are counted where some are put or taken")
        if what == "ask":
            answers.append(boxes[shelf])
        elif what == "put":
            boxes[shelf] += count
        elif boxes[shelf] < count:
            answers.append(None)
        else:
            boxes[shelf] -= count
            answers.append(boxes[shelf])
    return answers


def write(shelves, steps):
    done = {
        "put": "put {1} on shelf {0}",
        "take": "take {1} from shelf {0}",
        "ask": "how many on shelf {0}",
    }
    lines = [done[what].format(shelf, count) for what, shelf, count in steps]
    return "\n".join([f"{shelves} shelves", *lines, "end"]) + "\n"


def read(output):
    lines = output.splitlines()
    for line in lines:
        if line != "refused" and not (line.isascii() and line.isdecimal()):
            raise ValueError(f"a line is a number or 'refused', not {line[:20]!r}")
    return [None if line == "refused" else int(line[:9]) for line in lines]


def show(answer):
    return "".join("refused\n" if each is None else f"{each}\n" for each in answer)


FORMAT = Format(write, read, show)
EXAMPLES = [(2, (("put", 1, 3), ("ask", 1, 0), ("take", 1, 4), ("take", 1, 1))), (1, (("ask", 1, 0),))]


def steps(most, longest, chance):
    def draw(draw):
        shelves, steps = draw.integer(1, most), []
        for _ in range(draw.integer(1, longest)):
            what = draw.choice(chance.split())
            steps.append((what, draw.integer(1, shelves), 0 if what == "ask" else draw.integer(1, 9)))
        return shelves, (*steps, ("ask", draw.integer(1, shelves), 0))

    return draw


GROUPS = [
    group("one-shelf", "One shelf, few steps.", steps(1, 5, "put take ask")),
    group("some-shelves", "Several shelves, many steps.", steps(6, 40, "put put take ask"), cases=20),
    group("refusals", "More is taken than there is.", steps(2, 20, "put take take ask"), cases=20),
]
