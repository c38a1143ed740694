"use strict";
/* What the page shows as pictures: the figure at true scale, the lens on what decides, and its gap by powers of ten.
   Doubles only place what is drawn, as seen from the figure's first point; `state.told` is exact, and page.js changes it. */

const by = id => document.getElementById(id);
const svg = (name, attributes = {}, ...children) => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
};
const shortened = text => {
  const [digits, exponent] = text.split("e");
  return digits.length > 12 ? `${digits.slice(0, 12)}…${exponent ? `e${exponent}` : ""}` : text;
};
/* A part of e in two digits. */
const part = x => {
  if (x === 0) return "0";
  const text = Math.abs(x) < 1e-3 ? x.toExponential(1) : String(Number(x.toPrecision(2)));
  return text.replace(".0e", "e").replace("-", "−").replace("e−", "e-");
};

const Drawing = (start, state) => {
  const FEW = 12;  // circles that each have a grip
  const small = () => innerWidth <= 544;
  let W = small() ? 380 : 640;  // units of the drawing, so that its words are readable on a phone
  const height = () => Math.round(W / (small() ? 1 : 1.18));
  const anchor = () => (state.told.rings[0] || state.told.handles[0]).at;
  const float = x => state.numbers.float(x);
  const seen = P => P.map((x, i) => float(x - anchor()[i]));
  const way = each => ({ p: seen(each.start), d: each.along.map(float), low: each.low, high: each.high });
  /* The figure's points that a person moves: [x, y] as seen from the anchor. */
  function grips() {
    const { handles, rings } = state.told, found = handles.map((each, i) => ({ ...each, id: `p${i}`, place: seen(each.at) }));
    const round = found.filter(each => each.ring && rings.length <= FEW).map(each => {
      const r = float(each.ring.r) * Math.SQRT1_2;
      return { id: `r${each.id.slice(1)}`, name: "r", centre: each.place, place: [each.place[0] + r, each.place[1] - r], slot: each.ring.slot };
    });
    return [...found, ...round];
  }

  function fit() {
    const { rings } = state.told, boxes = rings.map(({ at, r }) => [seen(at), float(r)]);
    const xs = [], ys = [];
    const add = ([x, y], r = 0) => {
      xs.push(x - r, x + r);
      ys.push(y - r, y + r);
    };
    for (const [at, r] of boxes) add(at, r);
    const reach = Math.max(...xs.map(Math.abs), ...ys.map(Math.abs), 0);
    for (const { place } of grips()) if (!rings.length || !reach || Math.hypot(...place) <= 12 * reach) add(place);
    const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const size = Math.max((x1 - x0) / W, (y1 - y0) / height()) * 1.3 || 1 / W;
    state.view = { x: (x0 + x1) / 2, y: (y0 + y1) / 2, size };
  }

  const far = v => Math.max(-1e5, Math.min(1e5, v));
  const place = ([x, y]) => {
    const { view } = state;
    return [far(W / 2 + (x - view.x) / view.size), far(height() / 2 - (y - view.y) / view.size)];
  };

  function gridStep() {
    const rough = state.view.size * 60, power = 10 ** Math.floor(Math.log10(rough));
    return [1, 2, 5, 10].find(each => each * power >= rough) * power;
  }

  function drawGrid(board) {
    const { view } = state, h = height(), step = gridStep(), [cx, cy] = anchor().map(float);
    const lines = (centre, middle, span) => {
      const low = Math.ceil((centre + middle - span * view.size / 2) / step), found = [];
      for (let i = 0; i < 40; i += 1) {
        const at = (low + i) * step - centre;
        if (at > middle + span * view.size / 2) break;
        found.push([at, low + i === 0]);
      }
      return found;
    };
    const number = (value, at) => {
      const text = svg("text", { ...at, class: "halo small" });
      text.textContent = String(Number((Math.abs(value) < step / 1e3 ? 0 : value).toPrecision(6))).replace("-", "−");
      return text;
    };
    for (const [x, axis] of lines(cx, view.x, W)) {
      const [px] = place([x, 0]);
      board.append(svg("line", { x1: px, x2: px, y1: 0, y2: h, class: axis ? "axis" : "grid" }));
      if (px > 20 && px < W - 20) board.append(number(cx + x, { x: px, y: h - 6, "text-anchor": "middle" }));
    }
    for (const [y, axis] of lines(cy, view.y, h)) {
      const [, py] = place([0, y]);
      board.append(svg("line", { x1: 0, x2: W, y1: py, y2: py, class: axis ? "axis" : "grid" }));
      if (py < h - 24) board.append(number(cy + y, { x: 6, y: py - 4 }));
    }
  }

  /* A line, ray or segment as far as it is in view, whatever the distance of its own two points. */
  function drawWay(board, each) {
    const { p, d, low, high } = way(each), size = Math.hypot(...d);
    if (!size) return;
    const u = [d[0] / size, d[1] / size], { view } = state;
    const along = (view.x - p[0]) * u[0] + (view.y - p[1]) * u[1], reach = view.size * W * 2;
    const stroke = (from, to, name) => {
      const [a, b] = [Math.max(from, along - reach), Math.min(to, along + reach)];
      if (a >= b) return;
      const [[x1, y1], [x2, y2]] = [a, b].map(s => place([p[0] + s * u[0], p[1] + s * u[1]]));
      board.append(svg("line", { x1, y1, x2, y2, class: name }));
    };
    if (each.role === "part" && (low !== null || high !== null)) stroke(-Infinity, Infinity, "whole");
    stroke(low === null ? -Infinity : low * size, high === null ? Infinity : high * size, each.role);
  }

  function drawScene() {
    const board = by("scene"), { rings, ways, spots } = state.told;
    board.setAttribute("viewBox", `0 0 ${W} ${height()}`);
    const focused = document.activeElement && document.activeElement.dataset.handle;
    board.replaceChildren();
    drawGrid(board);
    for (const { at, r, role } of rings) {
      const [cx, cy] = place(seen(at));
      board.append(svg("circle", { cx, cy, r: Math.min(float(r) / state.view.size, 1e5), class: role }));
    }
    for (const each of ways) drawWay(board, each);
    for (const { at, role, text } of spots) {
      const [cx, cy] = place(seen(at));
      board.append(svg("circle", { cx, cy, r: role === "base" ? 4.5 : role === "hit" ? 10 : 8, class: role }));
      if (text) label(board, text, [cx, cy]);
    }
    for (const each of grips()) drawGrip(board, each);
    const again = focused && board.querySelector(`[data-handle="${focused}"]`);
    if (again) again.focus({ preventScroll: true });
  }

  function label(board, text, [x, y]) {
    const beside = x > W - 60 ? -14 : 12;
    const mark = svg("text", { x: x + beside, y: y < 30 ? y + 22 : y - 11, class: "halo", "text-anchor": beside < 0 ? "end" : "start" });
    mark.textContent = text;
    board.append(mark);
  }

  function drawGrip(board, each) {
    const exact = place(each.place), h = height(), round = each.slot !== undefined || each.ring;
    const [x, y] = [Math.max(14, Math.min(W - 14, exact[0])), Math.max(14, Math.min(h - 14, exact[1]))];
    const texts = (each.slots || [each.slot]).map(i => state.texts[i]);
    const made = svg("g", {
      class: `handle${round ? " round" : ""}${state.held === each.id ? " held" : ""}`, tabindex: "0", role: "button", "data-handle": each.id,
      "aria-label": `${each.name} ${texts.length > 1 ? `(${texts.join(", ")})` : texts[0]}, arrow keys move it`,
    });
    made.append(svg("circle", { cx: x, cy: y, r: 22, class: "reach" }));
    made.append(svg("circle", { cx: x, cy: y, r: each.slot === undefined ? 7.5 : 6, class: "grip" }));
    label(made, x === exact[0] && y === exact[1] ? each.name : `${each.name} (beyond)`, [x, y]);
    board.append(made);
  }

  /* -- what decides: the lens and the gap ------------------------------------------------------------------- */

  /* The decision that is closest, one that breaks the promise first. */
  const closest = () => state.told.decisions.reduce((x, y) => (x && Math.abs(x.part) <= Math.abs(y.part) ? x : y), null);
  const clear = start.clear ? 1 / start.clear : 0;

  function drawLens() {
    const board = by("lens"), w = 360, h = 170, middle = h / 2, found = closest();
    board.parentElement.hidden = !found;
    if (!found) return;
    board.setAttribute("viewBox", `0 0 ${w} ${h}`);
    board.replaceChildren();
    const gap = found.part, reach = Math.min(2, gap ? Math.abs(gap) * 1.6 : clear * 2 || 1e-9);
    const y = g => middle - (g / reach) * (middle - 14);
    const bend = x => -((x * reach * (w / h)) ** 2) / 2;
    const rim = Array.from({ length: 61 }, (_, i) => {
      const x = i / 30 - 1;
      return `${((x + 1) * w / 2).toFixed(1)},${Math.min(h + 9, y(Math.max(bend(x), -9 * reach))).toFixed(1)}`;
    });
    board.append(svg("polygon", { points: `0,${h} ${rim.join(" ")} ${w},${h}`, class: "disc" }));
    for (const edge of [clear, -clear]) {
      if (clear && clear < reach && clear > reach / 40) board.append(svg("line", { x1: 0, x2: w, y1: y(edge), y2: y(edge), class: "edge" }));
    }
    board.append(svg("polyline", { points: rim.join(" "), class: "rim" }));
    board.append(found.line ? svg("line", { x1: 0, x2: w, y1: y(gap), y2: y(gap), class: "here" })
      : svg("circle", { cx: w / 2, cy: y(gap), r: 6, class: "mark" }));
    by("lens-title").textContent = `Lens: ${found.says}. The gap is ${part(gap)}·e, and the window ±${part(reach)}·e high; e = ${shortened(state.told.size)}`;
  }

  function drawGap() {
    const board = by("gap"), w = 360, h = 62, decades = 16, found = closest();
    board.parentElement.hidden = !found;
    if (!found) return;
    board.setAttribute("viewBox", `0 0 ${w} ${h}`);
    board.replaceChildren();
    const x = g => {
      const size = Math.max(0, Math.min(1, (Math.log10(Math.abs(g) || 1e-99) + decades) / decades));
      return w / 2 + (g < 0 ? -1 : 1) * size * (w / 2 - 12);
    };
    if (clear) board.append(svg("rect", { x: x(-clear), width: x(clear) - x(-clear), y: 22, height: 16, class: "gap" }));
    board.append(svg("line", { x1: 12, x2: w - 12, y1: 30, y2: 30, class: "axis" }));
    const edges = clear ? [[-clear, "−1e-7"], [clear, "1e-7"]] : [];
    for (const [g, text] of [[-1, "−1"], [0, "0"], [1, "1"], ...edges]) {
      board.append(svg("line", { x1: x(g), x2: x(g), y1: 25, y2: 35, class: "axis" }));
      const mark = svg("text", { x: x(g), y: 55, class: "small", "text-anchor": "middle" });
      mark.textContent = text;
      board.append(mark);
    }
    for (const each of state.told.decisions) {
      board.append(svg("path", { d: `M${x(each.part)},26 l-6,-13 h12 z`, class: each === found ? "mark" : "mark other" }));
    }
    by("gap-title").textContent = "Every gap in parts of e, by powers of ten: 0 is exact"
      + (clear ? ", pink is almost and not a valid input, beyond it all is clear." : ".");
  }

  const resized = () => {
    const before = W;
    W = small() ? 380 : 640;
    state.view.size *= before / W;
    drawScene();
  };
  return { grips, anchor, float, fit, drawScene, drawLens, drawGap, resized, size: () => [W, height()] };
};
