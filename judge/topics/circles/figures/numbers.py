"""The number theory behind the recipes, over Python integers of any size.

Everything here is deterministic, and what comes out is checked (`x² + y² = n`): a composite that passes for a
prime could stop a build, but never make a wrong case.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd, isqrt, prod

from judge.data.draw import Draw, require

SMALL_PRIMES = tuple(n for n in range(2, 1000) if all(n % d for d in range(2, isqrt(n) + 1)))
_WITNESSES = SMALL_PRIMES[:16]  # prove primality below 3.3e24 (Sorenson and Webster, 2015)
_FEWER = (
    (3_215_031_751, 4),
    (3_474_749_660_383, 6),
    (3_825_123_056_546_413_051, 9),
)  # below which so many do
_SMALL_PRODUCT = prod(SMALL_PRIMES)
_INERT_PRODUCT = prod(prime for prime in SMALL_PRIMES if prime % 4 == 3)  # of those that are no x² + y²
_RHO_BUDGET = 1 << 17  # steps; finds factors up to about 1e10


def bezout(a: int, b: int) -> tuple[int, int, int]:
    """(x, y, g) with a·x + b·y = g = gcd(a, b) ≥ 0, by the extended Euclidean algorithm."""
    x, next_x, y, next_y = 1, 0, 0, 1
    while b:
        quotient = a // b
        a, b = b, a - quotient * b
        x, next_x = next_x, x - quotient * next_x
        y, next_y = next_y, y - quotient * next_y
    return (x, y, a) if a >= 0 else (-x, -y, -a)


def pythagorean(draw: Draw, size: int) -> tuple[int, int, int]:
    """A primitive triple (p, q, h): p² + q² = h² ≤ size², p and q not zero, either of them the even one."""
    require(size >= 5, "the smallest Pythagorean hypotenuse, 5, is within size")
    u = draw.integer(2, max(2, isqrt(size - 1)))
    v = draw.integer(1, min(u - 1, isqrt(size - u * u)))
    p, q, h = u * u - v * v, 2 * u * v, u * u + v * v
    common = gcd(p, q)
    p, q, h = p // common, q // common, h // common
    require(p * p + q * q == h * h and h <= size, "p² + q² = h²")
    return (p, q, h) if draw.boolean() else (q, p, h)


def off_by_one(draw: Draw, size: int, power: int) -> tuple[int, int, int]:
    """(x, y, r) with x² + y² − r² = power, which is 1 or −1; none above `size`, x and y in any ratio.

    With p·s + q·w = 2: x = (pq + sw)/2, y = (qw − ps)/2, r = (sw − pq)/2 give 1. With p·s − q·w = 1 and
    y = pw + qs: y² + 1 = (p² + q²)(s² + w²), and r + x and r − x are these factors.
    """
    reach = max(4, isqrt(size if power == 1 else size // 2))
    p, q = (draw.integer(1 + reach // 2, reach) for _ in range(2))
    if (p + q) % 2 == 0:
        q -= 1  # r and x are halves of sums: p and q of different parity make them whole
    s, w, common = bezout(p, q)
    if common != 1:
        draw.reject()
    back = -1 if s > 0 else 1  # s and s + back·q are of different signs, so both are at most q
    if power == 1:
        turns = draw.choice((0, back))
        s, w = 2 * s + turns * q, 2 * w - turns * p
        x, y, r = (p * q + s * w) // 2, (q * w - p * s) // 2, abs(s * w - p * q) // 2
    else:
        turns = back if (s + w) % 2 == 0 else 0
        s, w = s + turns * q, -w + turns * p
        first, second = p * p + q * q, s * s + w * w
        x, y, r = (first - second) // 2, p * w + q * s, (first + second) // 2
    require(x * x + y * y - r * r == power, f"x² + y² − r² = {power}")
    return x, y, r


def root_modulo_square(n: int, prime: int) -> int | None:
    """A root of n modulo prime², for a prime 4m + 3, or None where there is none or n is a multiple of it.

    Modulo the prime it is a power of n; Hensel's step then makes it one modulo the square.
    """
    require(prime % 4 == 3, "the prime is of the form 4m + 3")
    root = pow(n, (prime + 1) // 4, prime)
    if root == 0 or root * root % prime != n % prime:
        return None
    square = prime * prime
    root -= (root * root - n) * pow(2 * root, -1, square)
    require((root * root - n) % square == 0, "the root is one")
    return root % square


def is_prime(n: int) -> bool:
    """Whether n is prime, by the Miller–Rabin test; proven below 3e24, and beyond all doubt of use above."""
    if n < 2:
        return False
    if n <= SMALL_PRIMES[-1]:
        return n in SMALL_PRIMES
    if gcd(n, _SMALL_PRODUCT) > 1:
        return False
    if n < SMALL_PRIMES[-1] ** 2:
        return True
    twos = ((n - 1) & (1 - n)).bit_length() - 1
    odd = n - 1 >> twos
    enough = next((count for limit, count in _FEWER if n < limit), len(_WITNESSES))
    return not any(_is_witness(base, odd, twos, n) for base in _WITNESSES[:enough])


def _is_witness(base: int, odd: int, twos: int, n: int) -> bool:
    power = pow(base, odd, n)
    if power in (1, n - 1):
        return False
    for _ in range(twos - 1):
        power = power * power % n
        if power == n - 1:
            return False
    return True


def factors(n: int) -> dict[int, int] | None:
    """The prime factors of n ≥ 1 with their exponents, or None beyond a small budget of steps."""
    found: dict[int, int] = {}
    if gcd(n, _SMALL_PRODUCT) > 1:
        for prime in SMALL_PRIMES:
            while n % prime == 0:
                n //= prime
                found[prime] = found.get(prime, 0) + 1
    pending = [n] if n > 1 else []
    while pending:
        part = pending.pop()
        if is_prime(part):
            found[part] = found.get(part, 0) + 1
            continue
        root = isqrt(part)
        divisor = root if root * root == part else _divisor(part)
        if divisor is None:
            return None
        pending += [divisor, part // divisor]
    return found


def _divisor(n: int) -> int | None:
    """A proper divisor of the odd composite n by Pollard's rho with Brent's cycle search, or None."""
    for constant in (1, 3, 5):
        slow = fast = 2
        product, steps, lap = 1, 0, 1
        while steps < _RHO_BUDGET:
            slow, start = fast, steps
            while steps < start + lap:
                for _ in range(64):
                    fast = (fast * fast + constant) % n
                    product = product * (slow - fast) % n
                steps += 64
                divisor = gcd(product, n)
                if divisor == n:
                    break
                if divisor > 1:
                    return divisor
            else:
                lap *= 2
                continue
            break  # all factors met at once: another polynomial
    return None


def two_squares(n: int) -> tuple[int, int] | None:
    """(x, y) with x² + y² = n and gcd(x, y) = 1, or None if there is none or n is too hard to factor.

    Fermat and Gauss: it exists just when 4 does not divide n and no prime 4m + 3 does. Built as a product of
    Gaussian primes.
    """
    # Quickly seen: the odd part of such an n is 1 modulo 4, and has none of the small 4m + 3.
    if n < 1 or n % 4 in (0, 3) or (n % 8 == 6) or gcd(n, _INERT_PRODUCT) > 1:
        return None
    found = factors(n)
    if found is None or any(prime % 4 == 3 for prime in found):
        return None
    x, y = 1, 0
    for prime, exponent in found.items():
        u, v = (1, 1) if prime == 2 else two_squares_of_prime(prime)
        for _ in range(exponent):
            x, y = x * u - y * v, x * v + y * u
    require(x * x + y * y == n and gcd(x, y) == 1, f"{n} is {x}² + {y}²")
    return abs(x), abs(y)


def two_squares_of_prime(prime: int) -> tuple[int, int]:
    """(x, y) with x² + y² = prime, for a prime 4m + 1: Euclid's algorithm on √−1 (Hermite, Serret)."""
    base = next(b for b in SMALL_PRIMES if pow(b, (prime - 1) // 2, prime) == prime - 1)
    a, b = prime, pow(base, (prime - 1) // 4, prime)
    while b * b > prime:
        a, b = b, a % b
    return b, a % b


def pell(a: int, norm: int) -> Iterator[tuple[int, int]]:
    """The solutions (k, r) of k² − a·r² = norm in positive integers, growing without end; norm is 1 or −1.

    The first comes from the continued fraction of √a, the others by multiplying k + r√a. There is none for a
    square a, nor for norm −1 when the fraction's period is even.
    """
    root = isqrt(a)
    if root * root == a:
        return
    k_before, k, r_before, r = 1, root, 0, 1
    m, d, term = 0, 1, root
    while True:
        m = d * term - m
        d = (a - m * m) // d
        term = (root + m) // d
        if d == 1:  # a period is over: the convergent has norm 1 or −1
            break
        k_before, k = k, term * k + k_before
        r_before, r = r, term * r + r_before
    unit_norm = k * k - a * r * r
    if norm == -1 and unit_norm == 1:
        return
    step_k, step_r = (k, r) if unit_norm == 1 else (k * k + a * r * r, 2 * k * r)
    if norm == 1:
        k, r = step_k, step_r
    while True:
        require(k * k - a * r * r == norm, f"k² − {a}r² = {norm}")
        yield k, r
        k, r = k * step_k + a * r * step_r, k * step_r + r * step_k
