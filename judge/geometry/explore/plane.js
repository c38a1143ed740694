"use strict";
/* What every figure is made of: vectors, what decides, and what is drawn and told, over an arithmetic N of exact.js.

   A decision is a length that is 0, or clear: at least 1e-7 of the size e. `words` are its three sides and what is said
   where it is neither. */
const plane = (start, N) => {
  const { mul, div, sqrt, sign, int } = N;
  const zero = int(0), one = int(1);
  const told = { rings: [], ways: [], spots: [], handles: [], decisions: [], rows: [], answer: "", broken: null };
  let size = zero;  // e

  /* -- plane vectors --------------------------------------------------------------------------------------- */

  const abs = x => (x < zero ? -x : x);
  const largest = all => all.reduce((x, y) => (x > y ? x : y), zero);
  const plus = (p, q) => p.map((x, i) => x + q[i]);
  const minus = (p, q) => p.map((x, i) => x - q[i]);
  const times = (t, p) => p.map(x => mul(t, x));
  const dot = (p, q) => mul(p[0], q[0]) + mul(p[1], q[1]);
  const cross = (p, q) => mul(p[0], q[1]) - mul(p[1], q[0]);
  const long = p => sqrt(dot(p, p));
  const left = ([x, y]) => [-y, x];
  const signed = (which, x) => (which < 0 ? -x : which ? x : zero);
  const spans = (middle, all) => all.flatMap(P => minus(P, middle).map(abs));
  const measure = (middle, all, ...lengths) => { size = largest([...lengths, ...spans(middle, all)]); };
  const widen = (middle, all) => { size = largest([size, ...spans(middle, all)]); };

  /* -- what decides: a length that is 0, or clear ----------------------------------------------------------- */

  const clear = start.clear ? div(one, int(start.clear)) : zero;
  const spoken = (words, names) => words.map(text => text.replace("{point}", names[0]).replace("{figure}", names[1]));
  const refuse = what => { told.broken = told.broken || what; };
  function decide(words, gap, { share = clear, exactly = true, line = false } = {}) {
    const [almost, ...sides] = words, side = sign(gap), part = sign(size) ? div(gap, size) : zero;
    if (side ? abs(part) < share : !exactly && share !== zero) refuse(almost);
    told.decisions.push({ almost, side, says: sides[side + 1], gap: N.text(part, 0), part: N.float(part, 0), line });
    return side;
  }
  /* Whether a length is 0, or no less than size/share. */
  function least(length, share, what, exactly = true) {
    const short = sign(length) ? mul(int(share), length) < size : !exactly;
    if (short && start.clear) refuse(`${what} is ${sign(length) ? "too small" : "0"}`);
  }
  const on = (P, r, name, of = "the circle", options = {}) => decide(spoken(start.words.on, [name, of]), long(P) - r, options);

  /* f + t·d past a circle of radius r about (0, 0). */
  function line(f, d, r) {
    const a = dot(d, d), b = dot(f, d), c = dot(f, f) - mul(r, r), lone = sign(a) === 0;
    const delta = mul(b, b) - mul(a, c), root = sign(delta) > 0 ? sqrt(delta) : zero;
    const which = lone ? [] : [[], [0], [-1, 1]][sign(delta) + 1];
    const at = (w = 0) => div(signed(w, root) - b, a);
    const distance = lone ? null : div(abs(cross(d, f)), sqrt(a));
    const sides = {};
    return {
      f, d, r, a, b, delta, root, lone, which, at, distance,
      touch: (words = start.words.line, options = {}) => decide(words, distance - r, { line: true, ...options }),
      side: (t, name, of, words) => {
        const P = t ? plus(f, d) : f;
        sides[t] = sides[t] || [words ? decide(words, long(P) - r) : on(P, r, name, of)];
        return sides[t][0];
      },
      after: (w, t) => sign(at(w) - int(t)),
    };
  }

  /* -- what is drawn ---------------------------------------------------------------------------------------- */

  const handle = (name, at, slots, from = null) => told.handles.push({ name, at, slots, from });
  function disc(C, r, slots, name = "C", role = "circle") {
    told.rings.push({ at: C, r, role });
    if (slots) told.handles.push({ name, at: C, slots: slots.slice(0, 2), from: null, ring: slots[2] === undefined ? null : { r, slot: slots[2] } });
  }
  const way = (start_, along, low, high, role = "part") => told.ways.push({ start: start_, along, low, high, role });
  const mark = (at, role, text = "") => told.spots.push({ at, role, text });
  const row = (name, ...all) => told.rows.push([name, all.map(([x, dimension]) => N.text(x, dimension))]);
  const place = (name, P) => row(name, ...P.map(x => [x, 1]));
  const points = n => `${n} point${n === 1 ? "" : "s"}`;
  const short = (x, dimension) => shortened(N.text(x, dimension));

  return {
    told, zero, one, abs, largest, plus, minus, times, dot, cross, long, left, signed, measure, widen, clear, spoken,
    refuse, decide, least, on, line, handle, disc, way, mark, row, place, points, short, size: () => size,
  };
};
