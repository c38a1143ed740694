"use strict";
/* A circle and a line, segment or ray, decided exactly in BigInt: what judge/geometry/line.py does, for a page. A test
   holds each of its answers against that on thousands of cases.

   analyse(texts, kind, clear) takes seven numbers as text, cx cy r ax ay bx by, which are what Python reads: digits
   alone are an integer of any size, anything else is the double it is. kind is "line", "segment" or "ray" (of a ray
   bx by is the direction). clear is [n, m], BigInt shares of the size e: what decides is exact, or at least as long.
   Exact numbers come back as decimal text. */
const Exact = (() => {
  const DIGITS = 24;
  const abs = x => (x < 0n ? -x : x);
  const max = (...all) => all.reduce((x, y) => (x > y ? x : y));
  const sign = x => (x > 0n) - (x < 0n);
  const bits = x => abs(x).toString(2).length;

  function isqrt(x) {
    if (x < 2n) return x;
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
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, x);
    const word = view.getBigUint64(0);
    const exponent = Number((word >> 52n) & 2047n);
    let n = word & ((1n << 52n) - 1n), e = 1074;
    if (exponent) {
      n |= 1n << 52n;
      e = 1075 - exponent;
    }
    while (n && e > 0 && !(n & 1n)) {
      n >>= 1n;
      e -= 1;
    }
    if (e < 0) {
      n <<= BigInt(-e);
      e = 0;
    }
    return [word >> 63n ? -n : n, n ? e : 0];
  }

  /* The sign of p + q·√d. */
  function rootSign(p, q, d) {
    const first = sign(p), second = d === 0n ? 0 : sign(q);
    if (first === 0 || second === 0 || first === second) return first || second;
    return first * sign(p * p - q * q * d);
  }

  /* (p + q·√d)/s, s > 0, rounded half-even to so many digits, set as Python sets a float. */
  function decimal(p, q, d, s, digits = DIGITS) {
    let side = rootSign(p, q, d);
    if (side === 0) return "0";
    if (side < 0) [p, q] = [-p, -q];
    const floor = power => {
      const scale = 10n ** BigInt(Math.abs(power));
      const [P, Q, S] = power >= 0 ? [2n * p * scale, 2n * q * scale, s] : [2n * p, 2n * q, s * scale];
      const square = Q * Q * d, root = isqrt(square), whole = root * root === square;
      const top = Q < 0n ? P - root - (whole ? 0n : 1n) : P + root;
      return [top / S, whole && top % S === 0n];
    };
    let reach = digits + 8, seen = floor(reach)[0] >> 1n;
    while (seen === 0n) {
      reach *= 2;
      seen = floor(reach)[0] >> 1n;
    }
    let exponent = seen.toString().length - 1 - reach;
    const [doubled, settled] = floor(digits - 1 - exponent);
    const half = doubled & 1n;
    let number = doubled >> 1n;
    const exact = settled && !half;
    if (half && !(settled && !(number & 1n))) number += 1n;
    if (number === 10n ** BigInt(digits)) {
      number /= 10n;
      exponent += 1;
    }
    return (side < 0 ? "-" : "") + layout(number.toString(), exponent, exact);
  }

  function layout(text, exponent, exact) {
    if (exact) text = text.replace(/0+$/, "") || "0";
    if (exponent > -5 && exponent < 0) return "0." + "0".repeat(-exponent - 1) + text;
    if (exponent >= 0 && exponent < 16) {
      const whole = text.slice(0, exponent + 1).padEnd(exponent + 1, "0"), part = text.slice(exponent + 1);
      return part ? `${whole}.${part}` : whole;
    }
    const part = text.length > 1 ? `.${text.slice(1)}` : "";
    return `${text[0]}${part}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  }

  /* The case in integers, every length in units of 2**-shift. */
  function scaled(texts, kind) {
    const parsed = texts.map(parse);
    if (parsed.some(each => each === null)) return null;
    const shift = Math.max(...parsed.map(each => each[1]));
    const [cx, cy, r, ax, ay, bx, by] = parsed.map(([n, e]) => n << BigInt(shift - e));
    const ray = kind === "ray";
    const [dx, dy] = ray ? [bx, by] : [bx - ax, by - ay];
    const [fx, fy] = [ax - cx, ay - cy];
    const far = ray ? [] : [abs(bx - cx), abs(by - cy)];
    const extent = max(abs(r), abs(fx), abs(fy), ...far);
    const a = dx * dx + dy * dy, b = fx * dx + fy * dy, k = dx * fy - dy * fx;
    return { cx, cy, r, ax, ay, dx, dy, fx, fy, a, b, k, extent, shift: BigInt(shift), delta: r * r * a - k * k };
  }

  /* Whether √(square/weight) is not r, but nearer to it than the share n/m of the size. */
  function nearly(square, weight, c, [n, m]) {
    const width = n * c.extent, radius = m * c.r, reach = square * m * m;
    if (square === c.r * c.r * weight || (radius + width) ** 2n * weight <= reach) return false;
    const inner = radius - width;
    return inner < 0n || reach > inner * inner * weight;
  }

  /* Of a point of the line, t being 0 or 1: the square of its distance from the centre. */
  const away = (c, t) => (c.fx + BigInt(t) * c.dx) ** 2n + (c.fy + BigInt(t) * c.dy) ** 2n;

  /* The sign of the common point's parameter less t. */
  const beyond = (c, which, t) => rootSign(-c.b - BigInt(t) * c.a, BigInt(which), which ? c.delta : 0n);

  function kept(c, kind, found) {
    const ends = { line: [], ray: [0], segment: [0, 1] }[kind];
    return found.filter(which => ends.every(t => (t ? 1 : -1) * beyond(c, which, t) <= 0));
  }

  function brokenPromise(c, kind, clear) {
    const ends = { line: [], ray: [0], segment: c.a ? [0, 1] : [0] }[kind];
    const end = ends.find(t => nearly(away(c, t), 1n, c, clear));
    if (end !== undefined) return end ? "end" : "start";
    return c.a && nearly(c.k * c.k, c.a, c, clear) ? "touch" : null;
  }

  function analyse(texts, kind, clear) {
    const c = scaled(texts, kind);
    if (c === null || c.r < 0n) return null;
    const unit = 1n << c.shift, lone = c.a === 0n;
    const found = lone || c.delta < 0n ? [] : c.delta ? [-1, 1] : [0];
    const root = which => decimal(-c.b, BigInt(which), which ? c.delta : 0n, c.a);
    const point = which => [
      decimal(c.cx * c.a - c.k * c.dy, BigInt(which) * c.dx, which ? c.delta : 0n, c.a * unit),
      decimal(c.cy * c.a + c.k * c.dx, BigInt(which) * c.dy, which ? c.delta : 0n, c.a * unit),
    ];
    const onCircle = lone && kind === "segment" && away(c, 0) === c.r * c.r;
    const here = lone ? (onCircle ? [0] : []) : kept(c, kind, found);
    const told = {
      lone,
      count: lone ? null : found.length,
      kept: here,
      broken: brokenPromise(c, kind, clear),
      extent: decimal(c.extent, 0n, 0n, unit),
      delta: decimal(c.delta, 0n, 0n, unit ** 4n),
      all: found.map(which => ({ which, t: root(which), point: point(which), kept: here.includes(which) })),
    };
    if (kind === "ray") {
      const [first] = here;
      told.least = first === undefined ? null : root(first);
    }
    if (lone) return told;
    const length = c.a * unit;
    told.foot = { t: root(0), point: point(0) };
    told.distance = decimal(0n, abs(c.k), c.a, length);
    told.half = c.delta < 0n ? null : decimal(0n, 1n, c.delta * c.a, length);
    told.gap = c.extent ? decimal(-c.r * c.a, abs(c.k), c.a, c.a * c.extent) : "0";
    return told;
  }

  return { analyse, decimal, parse };
})();
