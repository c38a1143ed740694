"use strict";
/* A circle and a line, segment or ray, decided exactly in BigInt: what judge/topics/circles/line.py and bands.py do,
   for a page. A test holds each of its answers against those on thousands of cases.

   analyse(texts, kind, bands) takes seven numbers as text, cx cy r ax ay bx by, which are what Python reads: digits
   alone are an integer of any size, anything else is the double it is. kind is "line", "segment" or "ray" (of a ray
   bx by is the direction). bands is {snap: [n, m], clear: [n, m]}, BigInt shares of the extent. Exact numbers come
   back as decimal text. */
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

  /* The sign of p + q·√d, and of p + q·√d + u·√a. */
  function rootSign(p, q, d) {
    const first = sign(p), second = d === 0n ? 0 : sign(q);
    if (first === 0 || second === 0 || first === second) return first || second;
    return first * sign(p * p - q * q * d);
  }
  function twoRootSign(p, q, d, u, a) {
    const first = rootSign(p, q, d), second = a === 0n ? 0 : sign(u);
    if (first === 0 || second === 0 || first === second) return first || second;
    return first * rootSign(p * p + q * q * d - u * u * a, 2n * p * q, d);
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

  /* Whether |√square − r| is at most (strictly: less than) the share n/m of the extent, times √weight. */
  function close(square, weight, c, [n, m], strictly) {
    const least = strictly ? 1n : 0n, width = n * c.extent, radius = m * c.r, reach = square * m * m;
    if ((radius + width) ** 2n * weight - reach < least) return false;
    const inner = radius - width;
    return inner < 0n || reach - inner * inner * weight >= least;
  }
  const touches = (c, width, strictly) => close(c.k * c.k, c.a, c, width, strictly);
  const starts = (c, width, strictly) => close(c.fx * c.fx + c.fy * c.fy, 1n, c, width, strictly);

  /* Whether a root's distance to the place t (0 or 1) along the line is within the share of the extent. */
  function within(c, which, t, [n, m], strictly) {
    const u = -c.b - BigInt(t) * c.a, d = which ? c.delta : 0n;
    return [1n, -1n].every(side => {
      const outcome = twoRootSign(-side * u * m, -side * BigInt(which) * m, d, n * c.extent, c.a);
      return outcome > 0 || (outcome === 0 && !strictly);
    });
  }
  const beyond = (c, which, t) => rootSign(-c.b - BigInt(t) * c.a, BigInt(which), which ? c.delta : 0n);

  function kept(c, kind, found, bands) {
    if (kind === "line") return found;
    const ends = kind === "ray" ? [0] : [0, 1];
    return found.filter(which =>
      ends.every(t => (t ? 1 : -1) * beyond(c, which, t) <= 0 || within(c, which, t, bands.snap, false)));
  }

  function brokenPromise(c, kind, found, bands) {
    if (c.a === 0n) {
      const near = kind === "segment" && !starts(c, bands.snap, false) && starts(c, bands.clear, true);
      return near ? "start" : null;
    }
    if (!touches(c, bands.snap, false) && touches(c, bands.clear, true)) return "touch";
    for (const which of kind === "line" ? [] : found) {
      for (const t of kind === "ray" ? [0] : [0, 1]) {
        if (!within(c, which, t, bands.snap, false) && within(c, which, t, bands.clear, true)) {
          return t ? "end" : "start";
        }
      }
    }
    return null;
  }

  function analyse(texts, kind, bands) {
    const c = scaled(texts, kind);
    if (c === null || c.r < 0n) return null;
    const unit = 1n << c.shift, lone = c.a === 0n;
    const found = lone ? [] : touches(c, bands.snap, false) ? [0] : c.delta > 0n ? [-1, 1] : [];
    const root = which => decimal(-c.b, BigInt(which), which ? c.delta : 0n, c.a);
    const point = which => [
      decimal(c.cx * c.a - c.k * c.dy, BigInt(which) * c.dx, which ? c.delta : 0n, c.a * unit),
      decimal(c.cy * c.a + c.k * c.dx, BigInt(which) * c.dy, which ? c.delta : 0n, c.a * unit),
    ];
    const onCircle = lone && kind === "segment" && starts(c, bands.snap, false);
    const here = lone ? (onCircle ? [0] : []) : kept(c, kind, found, bands);
    const told = {
      lone,
      count: lone ? null : found.length,
      kept: here,
      broken: brokenPromise(c, kind, found, bands),
      extent: decimal(c.extent, 0n, 0n, unit),
      delta: decimal(c.delta, 0n, 0n, unit ** 4n),
      all: found.map(which => ({ which, t: root(which), point: point(which), kept: here.includes(which) })),
    };
    if (kind === "ray") {
      const [first] = here;
      told.least = first === undefined ? null : within(c, first, 0, bands.snap, false) ? "0" : root(first);
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
