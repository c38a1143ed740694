"""A number is guessed: halving what is left finds it."""

from judge.problem.declare import Format, InvalidCase, group


def solve(high, secret):
    if secret > high:
        raise InvalidCase(f"the number is {secret}, above {high}")


def talk(program, high, secret):
    program.say(high)
    for _ in range(high.bit_length()):
        guess = program.hear_int(1, high)
        if guess == secret:
            program.say("found")
            return None
        program.say("higher" if guess < secret else "lower")
    return f"the number is not found in {high.bit_length()} guesses"


FORMAT = Format(talk=talk)
EXAMPLES = [(6, 5), (1, 1)]


def numbers(least, most):
    def draw(draw):
        high = draw.integer(least, most)
        return high, draw.integer(1, high)

    return draw


def last(draw):
    high = draw.integer(1, 1000)
    return high, high


GROUPS = [
    group("few", "A few numbers.", numbers(2, 12), cases=20),
    group("many", "Many numbers.", numbers(1000, 1_000_000)),
    group("last", "It is the last of the numbers.", last),
]
