"use strict";
/* Two arithmetics for the same formulas: exact numbers in BigInt, and doubles. Both are added, subtracted and compared
   by JavaScript's own operators; mul, div, sqrt and sign are theirs.

   A number's text is what Python reads: digits alone are an integer of any size, anything else the double it is. An
   exact number is an integer in units of 2**-P, and a length is in units of 2**-shift besides. P is so large that
   numbers made of the case's by roots, products and quotients are 0 or far from it: `sign` is exact. */
const Exact = (() => {
  const DIGITS = 24;
  const abs = x => (x < 0n ? -x : x);
  const bits = x => abs(x).toString(16).length * 4;

  function isqrt(x) {
    if (x < 2n) return x < 0n ? 0n : x;
    let root = 1n << BigInt((bits(x) + 1) >> 1);
    for (;;) {
      const next = (root + x / root) >> 1n;
      if (next >= root) return root;
      root = next;
    }
  }

  /* A number's text as [n, e], the value n / 2**e; null where it is no finite number. */
  function parse(text) {
    const word = String(text).trim();
    if (/^[+-]?\d{1,4000}$/.test(word)) return [BigInt(word.replace(/^\+/, "")), 0];
    if (!/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(word)) return null;
    return Number.isFinite(Number(word)) ? dyadic(Number(word)) : null;
  }

  function dyadic(x) {
    let n = x, e = 0;
    for (; !Number.isInteger(n); e += 1) n *= 2;
    return [BigInt(n), e];
  }

  /* n / 2**e rounded to 24 digits, set as Python sets a float. */
  function decimal(n, e) {
    const size = abs(n);
    let power = Math.floor((bits(size) - e - 4) * Math.LOG10E * Math.LN2);  // at most the first digit's, and 1 less
    const scaled = places => {
      const top = places > 0 ? size * 10n ** BigInt(places) : size, unit = 1n << BigInt(e);
      const below = places < 0 ? unit * 10n ** BigInt(-places) : unit;
      return (2n * top + below) / (2n * below);
    };
    let number = scaled(DIGITS - 1 - power).toString();
    while (number.length > DIGITS) {
      power += 1;
      number = scaled(DIGITS - 1 - power).toString();
    }
    return (n < 0n ? "-" : "") + layout(number.replace(/0+$/, ""), power);
  }

  function layout(text, exponent) {
    if (exponent > -5 && exponent < 0) return `0.${"0".repeat(-exponent - 1)}${text}`;
    if (exponent >= 0 && exponent < 16) {
      const whole = text.slice(0, exponent + 1).padEnd(exponent + 1, "0"), part = text.slice(exponent + 1);
      return part ? `${whole}.${part}` : whole;
    }
    const part = text.length > 1 ? `.${text.slice(1)}` : "";
    return `${text[0]}${part}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  }

  /* The arithmetic for these numbers, which become `values`; null where one is none. */
  function arithmetic(texts) {
    const parsed = texts.map(parse);
    if (parsed.includes(null)) return null;
    const shift = Math.max(0, ...parsed.map(each => each[1]));
    const whole = parsed.map(([n, e]) => n << BigInt(shift - e));
    const precision = 256 + 24 * Math.max(shift, ...whole.map(bits));
    const P = BigInt(precision), least = 1n << (P / 2n);
    const sign = x => (abs(x) < least ? 0 : x > 0n ? 1 : -1);
    return {
      values: whole.map(x => x << P),
      int: n => BigInt(n) << P,
      mul: (x, y) => (x * y) >> P,
      div: (x, y) => (x << P) / y,
      sqrt: x => isqrt(x << P),
      sign,
      pure: x => x >> BigInt(shift),  // a number that is no length
      text: (x, dimension = 1) => (sign(x) ? decimal(x, precision + shift * dimension) : "0"),
      float(x, dimension = 1) {
        const spare = Math.max(0, bits(x) - 64), exponent = spare - precision - shift * dimension;
        const half = Math.trunc(exponent / 2);  // 2**exponent itself may be no double
        return Number(x >> BigInt(spare)) * 2 ** half * 2 ** (exponent - half);
      },
    };
  }

  return { arithmetic, parse };
})();

const Doubles = {
  arithmetic: texts => ({ ...Doubles, values: texts.map(Number) }),
  int: Number,
  mul: (x, y) => x * y,
  div: (x, y) => x / y,
  sqrt: Math.sqrt,
  sign: Math.sign,
  pure: x => x,
  text: String,
  float: x => x,
};
