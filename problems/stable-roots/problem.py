"""The real roots of a·t² + 2·b·t + c = 0 for the numbers as they are, to the last digits."""

from fractions import Fraction
from math import isqrt, ldexp

from judge.geometry import whole
from judge.geometry.scenes import either, equations, tried
from judge.problem.declare import group


def solve(a, b, c):
    return whole.roots(a, b, c)


def outgrown(draw):
    """b² is 2**40 to 2**420 times larger than |a·c|, and no number is extreme."""
    a, b, c = (draw.integer(1, 9999) * draw.sign() for _ in "abc")
    apart = draw.integer(-40, 40)
    return ldexp(a, apart), ldexp(b, draw.integer(33, 200)), ldexp(c, -apart)


def alone(draw):
    """One number that is not 0, most often c, and it is tiny."""
    numbers, place = [0, 0.0, 0], draw.choice((0, 1, 2, 2, 2, 2))
    numbers[place] = ldexp(draw.integer(1, 99) * draw.sign(), -draw.choice((36, 50, 70, 90, 500)))
    return tuple(numbers)


def apart(draw):
    """Δ is 1e-6 to 1e-2 of b²: doubles keep most of its digits, and not enough."""
    a, b = draw.integer(1140, 1200) * 2**42 + draw.integer(0, 2**42), 2**52 + draw.integer(2**45, 2**47)
    a, b = a / 2**52 * draw.sign(), b / 2**52 * draw.sign()
    c = b * b * (1 - draw.integer(1010, 1060) / (1000 * 10 ** draw.choice((2, 2, 2, 2, 3, 4, 5, 6)))) / a
    return a, b, c


def clouded(case):
    """Whether doubles put b² − a·c off by 1.5e-16 of b² and more."""
    a, b, c = map(Fraction, case)
    return abs(Fraction(case[1] * case[1] - case[0] * case[2]) - (b * b - a * c)) > b * b * 3 / 20 / 10**15


def counting(draw):
    """|a·c| is 2.6e-15 to 3.3e-15 of b²: without it both roots are 3 to 7 units in their last place off."""
    a, b = (draw.integer(2**52, 2**53 - 1) / 2**52 * draw.sign() for _ in "ab")
    return a, b, b * b * draw.integer(260, 330) / 10**17 / a * draw.sign()


def remote(draw):
    """Two roots of one sign, both beyond 2**60."""
    a, c, far, side = draw.integer(1, 99), draw.integer(1, 99), draw.integer(70, 500), draw.sign()
    b = (isqrt(a * c) + draw.integer(1, 50)) * draw.choice((1, -1, -1)) * side
    return ldexp(a * side, -far), b, ldexp(c * side, far)


INTERVIEW = [
    group("plain", "No roots, or two of similar size, in small numbers; a of either sign.", tried(equations.plain(50)), cases=80, skills="every kind of equation"),
    group("cancellation", "b² is up to 2**52 times larger than |a·c|: −b and √Δ agree in nearly all digits.", equations.cancellation(4, 52), cases=80, skills="stable root"),
    group("both-signs", "The same with a, b and c of either sign: where −b + √Δ adds, −b − √Δ subtracts, and the other way round.", equations.cancellation(24, 52), skills="stable root"),
    group("b-zero", "b is 0, also as 0.0 or −0.0: two roots of opposite signs, or none, or 0.", equations.b_zero(60), skills="zero has no sign"),
    group("c-zero", "c is 0: one of the roots is 0.", equations.c_zero(99), skills="zero has no sign"),
    group("linear", "a is 0: one root, none, or every t.", equations.linear(99), skills="every kind of equation"),
    group("zeros", "Two of the numbers are 0, or all of them; the third one may be tiny.", either(*2 * [equations.zeros(99)], alone), cases=90, skills="every kind of equation"),
    group("double", "The discriminant is 0: one root, given once.", equations.double(30), skills="every kind of equation"),
    group("repeated", "Neighbouring calls differ in one argument.", tried(equations.plain(20)), turns=True, skills="nothing kept between calls"),
]

PRODUCTION = [  # the same, where rounding bites
    group("b-small", "b is a quarter to 2**-52 of √|a·c|: it is far smaller than √Δ, and counts.", tried(equations.b_small()), skills="full precision"),
    group("full", "Three numbers of 53 bits and of similar size.", equations.full(), cases=120, skills="full precision"),
    group("near-double", "b² and a·c agree in up to 104 bits, and a double holds 53 of each.", tried(equations.near_double(8, 25)), skills="full precision"),
    group("hairline", "Discriminants of either sign, from the size of b² down to 1e-30 of it.", either(*4 * [tried(equations.near_double(2, 25))], tried(apart, clouded)), cases=200, skills="full precision"),
    group("finest", "Δ is 1 beside a b² of 1e31 and more: the roots are within a few units of their last place, and two.", tried(equations.finest()), skills="full precision"),
    group("wide", "Numbers of about 2**±560 and beyond, whose squares are no doubles, or roots beyond 2**60.", either(*4 * [tried(equations.wide((-596, -560, 540, 560), equations.plain(99), equations.cancellation(6, 50), equations.b_zero(99), equations.c_zero(99), equations.double(99), equations.near_double(4, 17), equations.linear(99)))], remote), cases=75, skills="scale by powers of two"),
    group("brink", "Near-double roots of hundreds of bits, and where b² is a double, but not what rounding leaves of it.", tried(equations.wide((-546, -543, -540, 461, 515, 530, 545, 550), equations.finest(), equations.near_double(22, 25))), cases=80, skills="scale by powers of two"),
    group("uneven", "One of b² and a·c is dozens to hundreds of binary orders larger than the other, and neither need be a double.", either(*9 * [tried(either(equations.uneven(-586, 586, 9999), equations.uneven(100, 586, 9999), equations.uneven(-586, -100, 9999)))], *3 * [outgrown], *2 * [counting]), cases=94, skills="scale by powers of two"),
]
