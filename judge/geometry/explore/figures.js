"use strict";
/* What a case is, what decides it and what its answer comes to, for each kind of `judge.geometry.views`.

   figure(kind, start, N, args) runs the same formulas in exact numbers or in doubles, which is a plain program. Promises
   are those of `solve`, in its order; a test holds both against it. */
const figure = (kind, start, N, args) => {
  const { mul, div, sqrt, sign, int } = N;
  const {
    told, zero, one, abs, largest, plus, minus, times, dot, cross, long, left, signed, measure, widen, clear, spoken,
    refuse, decide, least, on, line, handle, disc, way, mark, row, place, points, short, size,
  } = plane(start, N);

  /* The numbers and the points of a line and a circle about C; `kept` says which of them count. */
  function common(l, C, P, kept, low, high) {
    if (l.lone) return;
    way(P, l.d, low, high);
    const foot = plus(P, times(l.at(), l.d));
    way(C, minus(foot, C), 0, 1, "drop");
    mark(foot, "base");
    row("discriminant Δ", [l.delta, 4]);
    row("distance d", [l.distance, 1]);
    row("foot, t", [l.at(), 0]);
    place("foot", foot);
    if (l.which.length) row("half-chord", [div(l.root, sqrt(l.a)), 1]);
    l.which.forEach((w, i) => {
      const name = l.which.length > 1 ? `point ${i + 1}` : "touch", Q = plus(P, times(l.at(w), l.d));
      mark(Q, kept(w) ? "hit" : "missed");
      row(`${name}, t`, [l.at(w), 0]);
      place(kept(w) ? name : `${name}, not counted`, Q);
    });
  }

  /* What is said where A is B. */
  function same() {
    if (start.same) refuse(start.same.replace(/\.$/, ""));
    return "None: A is B";
  }

  function circleAndLine(numbers, slots) {
    const [cx, cy, r, ax, ay, bx, by_] = numbers.flat(), [ix, iy, ir, ...ends] = slots.flat();
    const C = [cx, cy], A = [ax, ay], B = [bx, by_], segment = kind.includes("segment");
    measure(C, [A, B], r);
    const l = line(minus(A, C), minus(B, A), r);
    disc(C, r, [ix, iy, ir]);
    handle("A", A, ends.slice(0, 2));
    handle("B", B, ends.slice(2));
    if (segment) for (const t of l.lone ? [0] : [0, 1]) l.side(t, t ? "B" : "A");
    if (!l.lone) l.touch();
    const kept = w => !segment || (l.after(w, 0) >= 0 && l.after(w, 1) <= 0);
    common(l, C, A, kept, ...(segment ? [0, 1] : [null, null]));
    const alone = l.lone && segment && sign(long(l.f) - r) === 0, n = alone ? 1 : l.which.filter(kept).length;
    if (alone) {
      mark(A, "hit");
      place("point", A);
    }
    told.answer = l.lone && !segment ? same() : points(n);
    if (kind !== "chord" || l.lone) return;
    const chord = div(l.root + l.root, sqrt(l.a));
    if (n) row("chord", [chord, 1]);
    told.answer = n ? `a chord of ${short(chord)}` : "None: no chord";
  }

  function circleAndRay([cx, cy, r, O, D], [ix, iy, ir, o, d]) {
    const C = [cx, cy];
    measure(C, [O], r);
    const l = line(minus(O, C), D, r);
    disc(C, r, [ix, iy, ir]);
    handle("O", O, o);
    handle("D", plus(O, D), d, O);
    if (kind !== "ray") least(r, 10_000, "The radius");
    l.side(0, "O");
    if (!l.lone) l.touch();
    const first = kind !== "ray" && !sign(r) ? undefined : l.which.find(w => l.after(w, 0) >= 0);
    common(l, C, O, w => w === first, 0, null);
    told.answer = first === undefined ? "None: no hit" : `a hit at t = ${short(l.at(first), 0)}`;
    if (first === undefined || kind === "ray") return;
    const P = plus(O, times(l.at(first), D)), out = minus(P, C);
    const unit = out.map(x => div(first > 0 ? -x : x, r)), turn = dot(D, unit);
    const answer = kind === "normal" ? unit : minus(D, times(turn + turn, unit));
    const reach = kind === "normal" ? times(r, unit) : times(div(r, long(D)), answer);
    way(P, reach, 0, 1, "half");
    row(kind, ...answer.map(x => [x, kind === "normal" ? 0 : 1]));
  }

  function circleAndPoint([cx, cy, r, P], [ix, iy, ir, p]) {
    const C = [cx, cy], f = minus(P, C);
    measure(C, [P], r);
    disc(C, r, [ix, iy, ir]);
    handle("P", P, p);
    if (kind === "tangents") least(r, 10_000, "The radius");
    const side = on(f, r, "P");
    row("distance from C", [long(f), 1]);
    told.answer = told.decisions[0].says;
    if (kind !== "tangents") return;
    const square = dot(f, f), over = sqrt(largest([square - mul(r, r), zero]));
    const touches = side < 0 ? [] : side && sign(r) ? [-r, r] : [zero];
    touches.forEach((reach, i) => {
      const turned = plus(times(mul(r, r), f), times(mul(reach, over), left(f)));
      const at = !sign(r) ? C : side ? plus(C, turned.map(x => div(x, square))) : P;
      way(P, minus(at, P), 0, null);
      mark(at, "hit");
      place(`point ${i + 1}`, at);
    });
    told.answer = points(touches.length);
  }

  const NAMES = () => start.args.map(each => each.name);
  function lineAndPoint([A, B, P], [a, b, p]) {
    const d = minus(B, A), f = minus(P, A), [first, second, third] = NAMES();
    measure(P, [A, B]);
    handle(first, A, a);
    handle(second, B, b);
    handle(third, P, p);
    if (!sign(dot(d, d))) {
      told.answer = same();
      return;
    }
    if (kind === "foot on an axis" && d.every(sign)) refuse("The line is neither level nor upright");
    const k = cross(d, f), share = div(dot(f, d), dot(d, d)), foot = plus(A, times(share, d));
    way(A, d, null, null);
    way(P, minus(foot, P), 0, 1, "drop");
    mark(foot, kind === "side" ? "base" : "hit");
    row(`cross product (${second} − ${first}) × (${third} − ${first})`, [k, 2]);
    row("distance", [div(abs(k), long(d)), 1]);
    row("foot, t", [share, 0]);
    place("foot", foot);
    const inside = sign(share) >= 0 && sign(share - one) <= 0;
    told.answer = `${third} is ${["on the right of the line", "exactly on the line", "on the left of the line"][sign(k) + 1]}`;
    if (kind !== "side") told.answer += inside ? "; its foot is on the segment" : "; its foot is beyond the segment";
  }

  function normalForm([A, B], [a, b]) {
    const d = minus(B, A), O = [zero, zero];
    measure(O, [A, B]);
    handle("A", A, a);
    handle("B", B, b);
    mark(O, "base", "(0, 0)");
    if (!sign(dot(d, d))) {
      told.answer = same();
      return;
    }
    const normal = left(d).map(x => div(x, long(d))), height = -dot(normal, A), foot = times(-height, normal);
    way(A, d, null, null);
    way(O, foot, 0, 1, "drop");
    mark(foot, "hit");
    row("unit normal", ...normal.map(x => [x, 0]));
    row("signed distance", [height, 1]);
    told.answer = `(0, 0) is ${["on the right of the line", "exactly on the line", "on the left of the line"][sign(height) + 1]}`;
  }

  function twoPoints([P, Q], [p, q]) {
    const [first, second] = NAMES(), d = minus(Q, P);
    measure(P, [Q]);
    handle(first, P, p);
    handle(second, Q, q);
    way(P, d, 0, 1, "bare");
    row("distance squared", [dot(d, d), 2]);
    row("distance", [long(d), 1]);
    told.answer = `${short(dot(d, d), 2)} is the distance squared`;
  }

  function diameter([A, B, P], [a, b, p]) {
    if (!sign(long(minus(B, A)))) same();
    const names = NAMES(), middle = plus(A, B).map(x => div(x, int(2))), r = div(long(minus(B, A)), int(2));
    measure(middle, [A, B, P]);
    disc(middle, r, null);
    [[A, a], [B, b], [P, p]].forEach(([at, slots], i) => handle(names[i], at, slots));
    way(A, minus(B, A), 0, 1, "drop");
    way(A, minus(P, A), 0, 1, "bare");
    way(B, minus(P, B), 0, 1, "bare");
    const product = dot(minus(P, A), minus(P, B));
    row("(P − A)·(P − B)", [product, 2]);
    told.answer = `P is ${["inside the circle", "exactly on the circle", "outside the circle"][sign(product) + 1]}`;
  }

  function twoCircles([x1, y1, r1, x2, y2, r2], slots) {
    const C = [x1, y1], v = minus([x2, y2], C), square = dot(v, v), apart = sqrt(square), tangents = kind !== "pair";
    measure(C, [[x2, y2]], r1, r2);
    disc(C, r1, slots.slice(0, 3), "C1");
    disc([x2, y2], r2, slots.slice(3), "C2");
    if (tangents) {
      least(r1, 1000, "r1", false);
      least(r2, 1000, "r2", false);
    }
    least(apart, 1000, "The distance of the centres", !tangents);
    row("distance of the centres", [apart, 1]);
    row("r1 + r2", [r1 + r2, 1]);
    row("|r1 − r2|", [abs(r1 - r2), 1]);
    const alike = !sign(square) && decide(start.words.same, r1 - r2) === 0;
    let [outer, inner] = [-1, -1];
    if (sign(square)) {
      outer = decide(start.words.outer, apart - r1 - r2);
      inner = decide(start.words.inner, apart - abs(r1 - r2));
    }
    const found = [];
    const add = (along, across, bottom) => found.push(
      plus(C, plus(times(along, v), times(across, left(v))).map(x => div(x, bottom))));
    if (tangents && sign(square)) {
      for (const reach of [r1 - r2, r1 + r2]) {
        const over = square - mul(reach, reach), root = sign(over) > 0 ? sqrt(over) : zero;
        for (const side of [[], [0], [1, -1]][sign(over) + 1]) add(mul(r1, reach), signed(side, mul(r1, root)), square);
      }
    } else if (alike && !sign(r1)) found.push(C);
    else if (outer <= 0 && inner >= 0) {
      const along = square + mul(r1, r1) - mul(r2, r2), twice = square + square;
      const root = outer && inner ? sqrt(largest([mul(int(4), mul(square, mul(r1, r1))) - mul(along, along), zero])) : zero;
      for (const side of outer && inner ? [1, -1] : [0]) add(along, signed(side, root), twice);
    }
    found.forEach((P, i) => {
      mark(P, "hit");
      if (tangents) way(P, left(minus(P, C)), null, null, "whole");
      place(`point ${i + 1}`, P);
    });
    told.answer = alike && sign(r1) ? "None: one and the same circle" : points(found.length);
  }

  /* -- many circles and a ray ------------------------------------------------------------------------------- */

  const TAGS = { "-1": "enter", 0: "touch", 1: "exit" };
  function shoot(circles, O, D, slots, [o, d]) {
    if (slots) circles.forEach(([x, y, r], i) => disc([x, y], r, slots[i], String(i)));
    if (o) handle("O", O, o);
    if (d) handle("D", plus(O, D), d, O);
    way(O, D, 0, null);
    if (!sign(dot(D, D))) refuse("D is (0, 0)");
    return circles.map(([x, y, r]) => line(minus(O, [x, y]), D, r));
  }

  /* The hits in order of t; one that the ray leaves behind decides nothing but O. */
  function everyHit(lines) {
    const found = [];
    lines.forEach((l, index) => {
      if (l.side(0, "O") > 0 && sign(l.b) >= 0) return;
      if (!l.lone) l.touch();
      for (const w of l.which) if (l.after(w, 0) >= 0) found.push({ index, w, t: l.at(w) });
    });
    return found.sort((p, q) => (p.t < q.t ? -1 : 1));
  }
  const apart = (p, q, D) => decide(start.words.places, mul(q.t - p.t, long(D)));

  function hits([circles, O, D, program], [c, o, d]) {
    measure(O, circles.map(C => C.slice(0, 2)), ...circles.map(C => C[2]));
    const found = everyHit(shoot(circles, O, D, c, [o, d])), places = [];
    for (const hit of found) {
      const last = places[places.length - 1];
      if (last && !apart(last[0], hit, D)) last.push(hit);
      else places.push([hit]);
      mark(plus(O, times(hit.t, D)), "hit");
    }
    if (!program) {
      found.forEach(hit => row(`${TAGS[hit.w]} ${hit.index}, t`, [hit.t, 0]));
      told.answer = found.length ? found.map(hit => `${TAGS[hit.w]} ${hit.index}`).join(", ") : "no hit";
      return;
    }
    const below = program.some(x => sign(N.pure(x) + int(3)) < 0);  // before it is rounded
    const spans = below ? null : inSolid(circles.length, places, program.map(x => Math.round(N.float(x))));
    if (spans === null) {
      refuse("The program is no solid");
      return;
    }
    spans.forEach(([low, high], i) => {
      way(plus(O, times(low, D)), times(high - low, D), 0, 1, "half");
      row(`span ${i + 1}, from t`, [low, 0]);
      row(`span ${i + 1}, to t`, [high, 0]);
    });
    told.answer = spans.length ? `${spans.length} span${spans.length > 1 ? "s" : ""}` : "no span";
  }

  function inSolid(discs, places, program) {
    const within = held => {
      const stack = [];
      for (const step of program) {
        if (step >= discs || step < -3 || (step < 0 && stack.length < 2)) return null;
        if (step >= 0) stack.push(held[step]);
        else {
          const [p, q] = stack.splice(-2);
          stack.push(step === -1 ? p || q : p && q === (step === -2));
        }
      }
      return stack.length === 1 ? stack[0] : null;
    };
    const all = places.flat(), enters = all.filter(hit => hit.w < 0).map(hit => hit.index);
    const held = Array.from({ length: discs }, (_, i) => all.some(hit => hit.w > 0 && hit.index === i) && !enters.includes(i));
    if (within(held) === null) return null;
    const cuts = places.map(place_ => [place_[0].t, place_]), found = [];
    if (!cuts.length || sign(cuts[0][0])) cuts.unshift([zero, []]);
    let begun = null;
    for (const [t, those] of cuts) {
      for (const hit of those) if (hit.w) held[hit.index] = hit.w < 0;
      const now = within(held);
      if (now && begun === null) begun = t;
      if (!now && begun !== null) {
        found.push([begun, t]);
        begun = null;
      }
    }
    return found;
  }

  function light([circles, O, D, L], [c, o, d, l]) {
    measure(O, [...circles.map(C => C.slice(0, 2)), L], ...circles.map(C => C[2]));
    const lines = shoot(circles, O, D, c, [o, d]), never = { exactly: false };
    handle("L", L, l);
    told.answer = "None: no hit";
    if (!sign(dot(D, D))) return;
    const outside = lines.map((each, i) => {
      const [x, y, r] = circles[i];
      least(r, 10_000, "A radius", false);
      on(each.f, r, "O", "a circle", never);
      each.touch(spoken(start.words.tangent, ["The ray's line", "a circle"]), never);
      return on(minus(L, [x, y]), r, "L", "a circle", never);
    });
    const found = [];
    lines.forEach((each, index) => {
      for (const w of each.which) if (each.after(w, 0) >= 0) found.push({ index, w, t: each.at(w) });
    });
    if (!found.length) return;
    const { index, w, t } = found.reduce((p, q) => (q.t < p.t ? q : p));
    const P = plus(O, times(t, D)), view = minus(L, P), [ox, oy, r] = circles[index];
    mark(P, "hit", "P");
    way(P, view, 0, 1, "half");
    row("first hit, t", [t, 0]);
    place("P", P);
    const facing = decide(start.words.level, div(dot(view, minus(P, [ox, oy])), r), { share: start.clear ? div(one, int(1_000_000)) : zero, exactly: false });
    decide(start.words.again, div(mul(int(2), abs(dot(view, minus(P, [ox, oy])))), long(view)), { exactly: false });
    const blocked = circles.map(([x, y, s], i) => {
      if (i === index) return false;
      const f = minus(P, [x, y]), here = on(f, s, "P", "another circle", never), to = line(f, view, s);
      if (to.lone) return false;
      const far = to.touch(spoken(start.words.tangent, ["The line from P to L", "a circle"]), never);
      if (here !== outside[i] || here < 0) return here !== outside[i];
      return far < 0 && sign(to.at()) > 0 && sign(to.at() - one) < 0;
    });
    const dark = facing !== -w ? "the circle's own far side is in the way"
      : w > 0 && outside[index] > 0 ? "the circle's own wall is in the way" : blocked.includes(true) ? "another circle is in the way" : "";
    told.answer = dark ? `dark: ${dark}` : "lit";
  }

  /* From below 0 to π: 0 for angles below 0, 1 for those from 0 up to π, 2 for π itself. */
  const turn = D => (sign(D[1]) < 0 ? 0 : !sign(D[1]) && sign(D[0]) < 0 ? 2 : 1);

  /* The first hit of each ray; what is behind it, or clearly further, decides nothing. */
  function many([circles, ...rest], [c, ...slots]) {
    if (rest.length === 2) circles.forEach(([x, y, r], i) => {
      const f = minus(rest[0], [x, y]);
      if (sign(dot(f, f) - mul(r, r)) <= 0) refuse(`O is in circle ${i}, or on it`);
    });
    if (rest.length === 2) rest[1].slice(1).forEach((D, i) => {
      const before = rest[1][i], apart = turn(before) - turn(D);
      if (apart > 0 || (!apart && sign(cross(before, D)) < 0)) refuse(`Direction ${i} comes before one of a lesser angle`);
    });
    const pairs = rest.length === 2 ? rest[1].map(D => [rest[0], D]) : rest[0];
    const places = rest.length === 2 ? slots[1].map((d, i) => [i ? null : slots[0], d]) : slots[0];
    told.answer = pairs.map(([O, D], i) => {
      measure(O, circles.map(C => C.slice(0, 2)), ...circles.map(C => C[2]));
      const lines = shoot(circles, O, D, i ? null : c, places[i]), margin = clear + div(clear, int(5));
      if (!sign(dot(D, D))) return "None";
      const near = lines.map((l, index) => candidate(l, mul(margin, size()), index)).filter(each => each !== null);
      const best = near.filter(each => each.w).reduce((x, y) => (x === null || y.at < x ? y.at : x), null);
      const asked = near.filter(each => best === null || each.at <= best + mul(margin, size()));
      const met = asked.length === 1 && asked[0].w ? [{ ...asked[0], t: lines[asked[0].index].at(asked[0].w) }] : asked.flatMap(({ index }) => {
        const l = lines[index], side = l.side(0, "O");
        if (side > 0 && sign(l.b) > 0) return [];
        l.touch();
        const w = l.which.find(each => l.after(each, 0) >= 0);
        return w === undefined ? [] : [{ index, w, t: l.at(w) }];
      });
      if (!met.length) return "None";
      const first = met.reduce((p, q) => (q.t < p.t ? q : p));
      const ties = met.filter(hit => hit === first || !apart(first, hit, D)).map(hit => hit.index);
      mark(plus(O, times(first.t, D)), "hit");
      row(`ray ${i}: circle ${ties.join(" or ")}, t`, [first.t, 0]);
      return ties.join(" or ");
    }).join(", ");
  }

  /* How far along the ray a circle may be met, and at which root where that is clear; null for never. */
  function candidate(l, margin, index) {
    const gap = l.distance - l.r, middle = -div(l.b, sqrt(l.a));
    if (gap > margin) return null;
    if (gap < -margin) {
      const half = sqrt(-mul(gap, gap + l.r + l.r)), beside = long(l.f) - l.r;
      if (beside > margin) return middle > zero ? { at: middle - half, w: -1, index } : null;
      return beside < -margin ? { at: middle + half, w: 1, index } : { at: zero, w: 0, index };
    }
    const reach = l.r + margin, half = sqrt(largest([mul(reach, reach) - mul(l.distance, l.distance), zero]));
    return middle + half < -margin ? null : { at: largest([zero, middle - half]), w: 0, index };
  }

  /* -- outlines, motion, sequences --------------------------------------------------------------------------- */

  function polygon([cx, cy, r, V], [ix, iy, ir, v]) {
    const C = [cx, cy];
    measure(C, V, r);
    disc(C, r, [ix, iy, ir]);
    const found = [];
    V.forEach((P, i) => {
      const next = V[(i + 1) % V.length], l = line(minus(P, C), minus(next, P), r);
      handle(`V${i}`, P, v[i]);
      way(P, l.d, 0, 1);
      least(sqrt(l.a), 1_000_000_000, "An edge", false);
      if (l.lone) return;
      l.touch(start.words.edge);
      for (const w of l.which) {
        l.side(0, "A corner");
        if (l.after(w, 0) < 0) continue;
        l.side(1, "A corner");
        if (l.after(w, 1) < 0) found.push([i, plus(P, times(l.at(w), l.d))]);
      }
    });
    found.forEach(([i, P]) => {
      mark(P, "hit");
      place(`edge ${i}`, P);
    });
    told.answer = points(found.length);
  }

  function moving(name, from, to, r, [p, q, slot]) {
    disc(from, r, [...p, slot], `${name}0`);
    disc(to, r, q, `${name}1`, "ghost");
    way(from, minus(to, from), 0, 1, "drop");
  }
  function meeting(t, ...discs) {
    told.answer = t === null ? "None: they never touch" : sign(t) ? `they touch at t = ${short(t, 0)}` : "in touch at t = 0";
    if (t === null) return;
    row("t", [t, 0]);
    for (const [P, d, r] of discs) disc(plus(P, times(t, d)), r, null, "", "met");
  }

  function balls([P0, P1, r, Q0, Q1, s], [p0, p1, ir, q0, q1, is]) {
    measure(P0, [P1, Q0, Q1], r + s);
    moving("P", P0, P1, r, [p0, p1, ir]);
    moving("Q", Q0, Q1, s, [q0, q1, is]);
    const p = minus(P1, P0), q = minus(Q1, Q0), l = line(minus(P0, Q0), minus(p, q), r + s);
    const { start: before, end, touch } = start.words;
    least(sqrt(l.a), 1000, "The way of one disc as seen from the other");
    let t = null;
    if (l.side(0, "", "", before) <= 0) t = zero;
    else if (sign(l.b) < 0) {
      l.side(1, "", "", end);
      l.touch(touch);
      if (l.which.length && l.after(l.which[0], 1) <= 0) t = l.at(l.which[0]);
    }
    meeting(t, [P0, p, r], [Q0, q, s]);
  }

  function wall([P0, P1, r, A, B], [p0, p1, ir, a, b]) {
    const d = minus(P1, P0), w = minus(B, A), f = minus(P0, A), square = dot(w, w), turn = cross(w, d);
    measure(P0, [A, B], r);
    widen(P1, [A, B]);
    moving("P", P0, P1, r, [p0, p1, ir]);
    way(A, w, 0, 1);
    handle("A", A, a);
    handle("B", B, b);
    const caps = [line(f, d, r), line(minus(P0, B), d, r)], { start: before, end, touch } = start.words;
    least(sqrt(caps[0].a), 1000, "The way");
    least(sqrt(square), 10_000, "The wall");
    if (sign(turn) && mul(int(10_000), abs(turn)) < sqrt(mul(square, caps[0].a))) refuse("The way and the wall are almost parallel");
    const beside = t => {
      const x = plus(f, times(int(t), d)), foot = dot(x, w);
      if (sign(foot) > 0 && sign(foot - square) < 0) return decide(t ? end : before, div(abs(cross(w, x)), sqrt(square)) - r);
      return caps[sign(foot) > 0 && sign(square) ? 1 : 0].side(t, "", "", t ? end : before);
    };
    if (beside(0) <= 0) {
      meeting(zero, [P0, d, r]);
      return;
    }
    if (caps[0].lone) {
      meeting(null);
      return;
    }
    beside(1);
    const found = caps.flatMap(cap => {
      cap.touch(touch);
      return cap.which.slice(0, 1).map(each => cap.at(each));
    });
    if (sign(turn)) {
      for (const far of [-r, r]) {
        const t = div(mul(far, sqrt(square)) - cross(w, f), turn), along = dot(plus(f, times(t, d)), w);
        if (sign(along) >= 0 && sign(along - square) <= 0) found.push(t);
      }
    }
    const ahead = found.filter(t => sign(t) > 0), t = ahead.reduce((p, q) => (p === null || q < p ? q : p), null);
    meeting(t !== null && sign(t - one) <= 0 ? t : null, [P0, d, r]);
  }

  function frames([circles, O, D, h], [c, o, d]) {
    const lines = shoot(circles, O, D, c, [o, d]), share = N.pure(h), shown = [];
    told.ways[0].low = null;
    if (lines[0].lone) return;
    lines.forEach((l, i) => {
      const [x, y, r] = circles[i], { first, threshold } = start.words;
      measure(O, [[x, y]], r);
      row(`frame ${i}, d`, [l.distance, 1]);
      if (!i) {
        shown.push(decide(first, l.distance - r, { exactly: false, line: true }) < 0 ? 1 : 0);
        return;
      }
      const low = decide(threshold, l.distance - mul(r, one - share), { line: true });
      const high = decide(threshold, l.distance - mul(r, one + share), { line: true });
      shown.push(shown[i - 1] ? Number(high <= 0) : Number(low < 0));
    });
    told.answer = shown.join(" ");
  }

  function rows([cx, cy, r, A, B], [ix, iy, ir, a, b]) {
    handle("A", A, a);
    handle("B", B, b);
    way(A, minus(B, A), null, null);
    if (!sign(long(minus(B, A)))) same();
    told.answer = cx.map((x, i) => {
      const C = [x, cy[i]], l = line(minus(A, C), minus(B, A), r[i]);
      disc(C, r[i], [ix[i], iy[i], ir[i]], String(i));
      if (l.lone) return "";
      measure(C, [A, B], r[i]);
      l.touch();
      for (const w of l.which) mark(plus(A, times(l.at(w), l.d)), "hit");
      row(`circle ${i}, d − r`, [l.distance - r[i], 1]);
      return l.which.length;
    }).join(" ");
  }

  const FIGURES = {
    line: circleAndLine, points: circleAndLine, chord: circleAndLine, seven: circleAndLine, segment: circleAndLine,
    "count in a segment": circleAndLine, ray: circleAndRay, normal: circleAndRay, reflection: circleAndRay,
    point: circleAndPoint, tangents: circleAndPoint, foot: lineAndPoint, "foot on an axis": lineAndPoint,
    side: lineAndPoint, "normal form": normalForm, "two points": twoPoints, diameter, pair: twoCircles,
    "common tangents": twoCircles, hits, spans: hits, light, polygon, balls, wall, frames, rows, many,
  };
  let next = 0;
  const numbers = value => (Array.isArray(value) ? value.map(numbers) : N.values[next++]);
  const given = args.map(numbers);
  next = 0;
  const slots = value => (Array.isArray(value) ? value.map(slots) : next++);
  FIGURES[kind](given, args.map(slots));
  told.size = N.text(size());
  return told;
};
