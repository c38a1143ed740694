"use strict";
/* What the page shows as pictures: the figure at true scale, the lens on its gap, and the gap by powers of ten.
   Doubles only place what is drawn; what is drawn comes from Exact by way of `state`, which page.js changes. */

const KINDS = { line: ["line", "A", "B"], segment: ["segment", "A", "B"], ray: ["ray", "O", "D"] };
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

const Drawing = (start, state) => {
  const numbers = () => state.texts.map(Number);
  /* The figure as seen from the centre, in doubles: [r, ax, ay, bx, by], b the point that the second handle has. */
  function seen() {
    const [cx, cy, r, ax, ay, bx, by_] = numbers();
    const a = [ax - cx, ay - cy];
    const b = state.kind === "ray" ? [a[0] + bx, a[1] + by_] : [bx - cx, by_ - cy];
    return { cx, cy, r, a, b };
  }

  /* -- the scene ------------------------------------------------------------------------------------------ */

  const small = () => innerWidth <= 544;
  let W = small() ? 380 : 640;  // units of the drawing, so that its words are readable on a phone
  const height = () => Math.round(W / (small() ? 1 : 1.18));

  function fit() {
    const { r, a, b } = seen();
    const near = [a, b].filter(([x, y]) => Math.hypot(x, y) <= 12 * (r || 1e300));
    const xs = [-r, r, ...near.map(p => p[0])], ys = [-r, r, ...near.map(p => p[1])];
    const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const size = Math.max((x1 - x0) / W, (y1 - y0) / height()) * 1.3 || 1 / W;
    state.view = { x: (x0 + x1) / 2, y: (y0 + y1) / 2, size };
  }

  const place = ([x, y]) => {
    const far = v => Math.max(-1e5, Math.min(1e5, v));
    const { view } = state;
    return [far(W / 2 + (x - view.x) / view.size), far(height() / 2 - (y - view.y) / view.size)];
  };

  function gridStep() {
    const rough = state.view.size * 60, power = 10 ** Math.floor(Math.log10(rough));
    return [1, 2, 5, 10].find(each => each * power >= rough) * power;
  }

  function drawGrid(board) {
    const { view } = state, h = height(), step = gridStep(), { cx, cy } = seen();
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

  /* Two far points of the line in view, whatever the distance of its own two points. */
  function across(a, b) {
    const dx = b[0] - a[0], dy = b[1] - a[1], length = Math.hypot(dx, dy);
    if (!length) return null;
    const u = [dx / length, dy / length], { view } = state;
    const along = (view.x - a[0]) * u[0] + (view.y - a[1]) * u[1], reach = view.size * W * 2;
    const at = s => [a[0] + s * u[0], a[1] + s * u[1]];
    return { at, low: along - reach, high: along + reach, length };
  }

  function drawScene() {
    const board = by("scene"), { r, a, b } = seen(), { told, kind } = state, h = height();
    board.setAttribute("viewBox", `0 0 ${W} ${h}`);
    const kept = document.activeElement && document.activeElement.dataset ? document.activeElement.dataset.handle : null;
    board.replaceChildren();
    drawGrid(board);
    const [ox, oy] = place([0, 0]), radius = Math.min(r / state.view.size, 1e5);
    board.append(svg("circle", { cx: ox, cy: oy, r: radius, class: "circle" }));
    const line = across(a, b);
    if (line) {
      const stroke = (from, to, name) => {
        const [p, q] = [place(line.at(from)), place(line.at(to))];
        board.append(svg("line", { x1: p[0], y1: p[1], x2: q[0], y2: q[1], class: name }));
      };
      const foot = -(a[0] * (b[0] - a[0]) + a[1] * (b[1] - a[1])) / line.length;
      const clip = s => Math.max(line.low, Math.min(line.high, s));
      stroke(line.low, line.high, "whole");
      if (kind === "line") stroke(line.low, line.high, "part");
      else stroke(clip(0), kind === "ray" ? line.high : clip(line.length), "part");
      const half = told.half === null || told.half === undefined ? 0 : Number(told.half);
      if (half) stroke(clip(foot), clip(foot + half), "half");
      const f = place(line.at(clip(foot)));
      board.append(svg("line", { x1: ox, y1: oy, x2: f[0], y2: f[1], class: "drop" }));
      board.append(svg("circle", { cx: f[0], cy: f[1], r: 4.5, class: "base" }));
      for (const each of told.all) {
        const [x, y] = place(line.at(clip(foot + each.which * half)));
        board.append(svg("circle", { cx: x, cy: y, r: each.kept ? 10 : 8, class: each.kept ? "hit" : "missed" }));
      }
    } else if (told.kept.length) {
      const [x, y] = place(a);
      board.append(svg("circle", { cx: x, cy: y, r: 12, class: "hit" }));
    }
    const [, first, second] = KINDS[kind];
    handle(board, "C", [0, 0], "C", "round");
    handle(board, "R", [r * Math.SQRT1_2, -r * Math.SQRT1_2], "r", "round");
    const one = !line && kind !== "ray";
    handle(board, "A", a, one ? "" : first, "");
    handle(board, "B", b, one ? `${first} = ${second}` : second, "");
    if (kept) {
      const again = board.querySelector(`[data-handle="${kept}"]`);
      if (again) again.focus({ preventScroll: true });
    }
  }

  function handle(board, id, at, label, name) {
    const exact = place(at), h = height();
    const [x, y] = [Math.max(14, Math.min(W - 14, exact[0])), Math.max(14, Math.min(h - 14, exact[1]))];
    const off = x !== exact[0] || y !== exact[1];
    const texts = { C: [0, 1], R: [2], A: [3, 4], B: [5, 6] }[id].map(i => state.texts[i]);
    const made = svg("g", {
      class: `handle ${name}${state.held === id ? " held" : ""}`, tabindex: "0", role: "button", "data-handle": id,
      "aria-label": `${label || id} ${texts.length > 1 ? `(${texts.join(", ")})` : texts[0]}, arrow keys move it`,
    });
    made.append(svg("circle", { cx: x, cy: y, r: 22, class: "reach" }));
    made.append(svg("circle", { cx: x, cy: y, r: id === "R" ? 6 : 7.5, class: "grip" }));
    const beside = x > W - 60 ? -14 : 12;
    const mark = svg("text", { x: x + beside, y: y < 30 ? y + 22 : y - 11, class: "halo",
      "text-anchor": beside < 0 ? "end" : "start" });
    mark.textContent = off ? `${label} (beyond)` : label;
    made.append(mark);
    board.append(made);
  }

  /* -- the lens and the gap ------------------------------------------------------------------------------- */

  const power = x => {
    if (x === 0) return "0";
    const text = Math.abs(x) < 1e-3 ? x.toExponential(1) : String(Number(x.toPrecision(2)));
    return text.replace(".0e", "e").replace("-", "−").replace("e−", "e-");
  };

  function drawLens() {
    const board = by("lens"), w = 360, h = 170, middle = h / 2, { told } = state;
    board.setAttribute("viewBox", `0 0 ${w} ${h}`);
    board.replaceChildren();
    board.parentElement.hidden = told.lone;
    if (told.lone || !told.gap) {
      by("lens-title").textContent = "There is no line, and so no place to look at closely.";
      return;
    }
    const gap = Number(told.gap), clear = Number(start.clear[0]) / Number(start.clear[1]);
    const reach = Math.min(2, gap ? Math.abs(gap) * 1.6 : clear * 2 || 1e-9);
    const y = g => middle - (g / reach) * (middle - 14);
    const e = Number(told.extent), r = Number(state.texts[2]) / e || 1e-300, bend = x => -((x * reach * (w / h)) ** 2) / 2 / r;
    const rim = [];
    for (let i = 0; i <= 60; i += 1) {
      const x = (i / 30 - 1) * 1;
      rim.push(`${((x + 1) * w / 2).toFixed(1)},${Math.min(h + 9, y(Math.max(bend(x), -9 * reach))).toFixed(1)}`);
    }
    board.append(svg("polygon", { points: `0,${h} ${rim.join(" ")} ${w},${h}`, class: "disc" }));
    for (const edge of [clear, -clear]) {
      if (clear && clear < reach && clear > reach / 40) board.append(svg("line", { x1: 0, x2: w, y1: y(edge), y2: y(edge), class: "edge" }));
    }
    board.append(svg("polyline", { points: rim.join(" "), class: "rim" }));
    board.append(svg("line", { x1: 0, x2: w, y1: y(gap), y2: y(gap), class: "here" }));
    const name = (text, at, up) => {
      const mark = svg("text", { x: 8, y: at + (up ? -7 : 17), class: "halo small" });
      mark.textContent = text;
      board.append(mark);
    };
    name(KINDS[state.kind][0], y(gap), gap >= 0);
    name("circle", y(0), gap < 0);
    by("lens-title").textContent = `Lens: the line's gap to the circle, d − r = ${power(gap)}·e; the window is `
      + `±${power(reach)}·e high. e = ${shortened(told.extent)}`;
  }

  function drawGap() {
    const board = by("gap"), w = 360, h = 62, { told } = state, decades = 16;
    board.setAttribute("viewBox", `0 0 ${w} ${h}`);
    board.replaceChildren();
    board.parentElement.hidden = told.lone;
    const clear = Number(start.clear[0]) / Number(start.clear[1]);
    const x = g => {
      const size = Math.max(0, Math.min(1, (Math.log10(Math.abs(g) || 1e-99) + decades) / decades));
      return w / 2 + (g < 0 ? -1 : 1) * size * (w / 2 - 12);
    };
    const strip = (from, to, name) => board.append(svg("rect", { x: from, width: to - from, y: 22, height: 16, class: name }));
    if (clear) strip(x(-clear), x(clear), "gap");
    board.append(svg("line", { x1: 12, x2: w - 12, y1: 30, y2: 30, class: "axis" }));
    for (const [g, text] of [[-1, "−1"], [-clear, "−1e-7"], [0, "0"], [clear, "1e-7"], [1, "1"]]) {
      if (!clear && g && Math.abs(g) < 1) continue;
      board.append(svg("line", { x1: x(g), x2: x(g), y1: 25, y2: 35, class: "axis" }));
      const mark = svg("text", { x: x(g), y: 55, class: "small", "text-anchor": "middle" });
      mark.textContent = text;
      board.append(mark);
    }
    if (told.lone || !told.gap) {
      by("gap-title").textContent = "";
      return;
    }
    const gap = Number(told.gap), at = x(gap);
    board.append(svg("path", { d: `M${at},26 l-6,-13 h12 z`, class: "mark" }));
    by("gap-title").textContent = "The gap in parts of e, by powers of ten: 0 touches exactly"
      + (clear ? ", orange is almost a touch and not a valid input, beyond it all is clear." : ".");
  }

  const resized = () => {
    const before = W;
    W = small() ? 380 : 640;
    state.view.size *= before / W;
    drawScene();
  };
  return { seen, fit, drawScene, drawLens, drawGap, resized, size: () => [W, height()] };
};
