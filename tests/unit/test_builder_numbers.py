"""The number theory behind the recipes, held against its definitions and against FLINT."""

from __future__ import annotations

from itertools import islice
from math import gcd, isqrt

import flint
import pytest

from judge.data.draw import Rejected, SeededDraw
from judge.topics.circles.figures import numbers


@pytest.mark.parametrize("seed", range(50))
def test_bezout_solves_its_equation(seed):
    draw = SeededDraw(f"bezout {seed}")
    size = 10 ** draw.integer(0, 40)
    a, b = draw.integer(-size, size), draw.integer(-size, size)
    x, y, common = numbers.bezout(a, b)
    assert a * x + b * y == common == gcd(a, b)


@pytest.mark.parametrize(("a", "b"), [(0, 0), (0, -7), (-7, 0), (1, 0), (-6, -4)])
def test_bezout_of_zeros_and_negatives(a, b):
    x, y, common = numbers.bezout(a, b)
    assert a * x + b * y == common == gcd(a, b)


@pytest.mark.parametrize("size", [5, 6, 13, 100, 10**6, 10**100])
def test_pythagorean_triples_are_primitive_and_within_their_size(size):
    draw = SeededDraw(f"pythagorean {size}")
    for _ in range(50):
        p, q, h = numbers.pythagorean(draw, size)
        assert p * p + q * q == h * h
        assert gcd(p, q) == 1
        assert min(p, q) > 0
        assert h <= size


@pytest.mark.parametrize("power", [1, -1])
@pytest.mark.parametrize("size", [50, 2**20, 2**28])
def test_points_off_a_circle_by_one_are_everywhere_on_it(power, size):
    found = set()
    for seed in range(300):
        try:
            found.add(numbers.off_by_one(SeededDraw(f"off/{seed}"), size, power))
        except Rejected:
            continue
    assert all(x * x + y * y - r * r == power and max(abs(x), abs(y), r) <= size for x, y, r in found)
    if size > 50:
        assert len(found) > 200
        slopes = sorted(abs(x) / r for x, _, r in found)
        assert slopes[len(slopes) // 4] < 0.6 < slopes[-len(slopes) // 4]


@pytest.mark.parametrize("prime", [3, 7, 1019, 2**61 - 1])
def test_a_root_modulo_a_square_is_one_or_there_is_none(prime):
    square = prime * prime
    for n in range(-40, 40):
        root = numbers.root_modulo_square(n, prime)
        residue = n % prime != 0 and pow(n, (prime - 1) // 2, prime) == 1
        assert (root is not None) == residue
        assert root is None or (0 <= root < square and (root * root - n) % square == 0)


def test_primes_below_a_hundred_thousand_are_those_of_a_sieve():
    limit = 100_000
    sieve = bytearray([1]) * limit
    sieve[0] = sieve[1] = 0
    for n in range(2, isqrt(limit) + 1):
        if sieve[n]:
            sieve[n * n :: n] = bytes(len(range(n * n, limit, n)))
    assert [n for n in range(limit) if numbers.is_prime(n)] == [n for n in range(limit) if sieve[n]]


@pytest.mark.parametrize("digits", [12, 20, 40, 100])
def test_large_primes_are_those_of_flint(digits):
    start = 10**digits
    ours = [n for n in range(start, start + 600) if numbers.is_prime(n)]
    assert ours == [n for n in range(start, start + 600) if flint.fmpz(n).is_probable_prime()]
    assert ours


@pytest.mark.parametrize("n", [3215031751, 3825123056546413051, 318665857834031151167461])
def test_strong_pseudoprimes_to_many_bases_are_not_prime(n):
    assert not numbers.is_prime(n)


@pytest.mark.parametrize("seed", range(40))
def test_factors_are_those_of_flint(seed):
    n = SeededDraw(f"factors {seed}").integer(1, 10**15)
    found = numbers.factors(n)
    assert found is not None
    assert found == {int(prime): exponent for prime, exponent in flint.fmpz(n).factor()}


def test_factors_of_squares_and_of_one():
    assert numbers.factors(1) == {}
    assert numbers.factors(1009**2) == {1009: 2}
    assert numbers.factors((10**9 + 7) ** 2) == {10**9 + 7: 2}


def test_factors_give_up_on_a_product_of_large_primes():
    assert numbers.factors((10**30 + 57) * (10**31 + 33)) is None


def test_two_squares_finds_a_primitive_sum_just_where_there_is_one():
    limit = 3000
    sums = {x * x + y * y for x in range(isqrt(limit) + 1) for y in range(isqrt(limit) + 1) if gcd(x, y) == 1}
    for n in range(1, limit):
        found = numbers.two_squares(n)
        assert (found is not None) == (n in sums), n
        if found is not None:
            assert found[0] ** 2 + found[1] ** 2 == n
            assert gcd(*found) == 1


@pytest.mark.parametrize("norm", [1, -1])
def test_pell_gives_every_solution_in_order(norm):
    for a in range(2, 60):
        wanted = [
            (k, r) for r in range(1, 2000) if (k := isqrt(a * r * r + norm)) ** 2 == a * r * r + norm and k
        ]
        found = []
        for k, r in numbers.pell(a, norm):
            if r >= 2000:
                break
            found.append((k, r))
        assert found == (wanted if isqrt(a) ** 2 != a else []), a


def test_pell_goes_on_to_any_size():
    k, r = next(islice(numbers.pell(61, 1), 30, None))
    assert k * k - 61 * r * r == 1
    assert r > 10**100
