"use strict";
/* The page of `judge explore`: the case, what is said of it, and how it is moved. What is decided comes from Exact. */
(() => {
  const start = JSON.parse(document.getElementById("start").textContent);
  const EXAMPLES = [
    ["Through", {}, ["0", "0", "5", "-7", "-1", "6", "4"]],
    ["A touch", {}, ["0", "0", "1", "-1.5", "1", "2", "1"]],
    ["A touch at an odd angle", {}, ["0.1", "0.6", "0.7", "-0.28", "1.76", "1.32", "0.56"]],
    ["Almost a touch: off by 1e-9, not a valid input", {}, ["0", "0", "1", "-1", "1.000000001", "1", "1.000000001"]],
    ["A near miss: off by 3e-7", {}, ["0", "0", "1", "-1", "1.0000003", "1", "1.0000003"]],
    ["Tiny", {}, ["0", "0", "1e-9", "-2e-9", "1.001e-9", "2e-9", "1.001e-9"]],
    ["Far from the origin", {}, ["100000000", "100000000", "1", "99999998", "100000001", "100000003", "100000001"]],
    ["An end on the circle", { segment: 1, ray: 1 }, ["0", "0", "5", "3", "4", "9", "7"]],
    ["Begins inside", { segment: 1, ray: 1 }, ["1", "0", "5", "2", "1", "8", "3"]],
    ["Not a line: both points are one", {}, ["0", "0", "5", "3", "4", "3", "4"]],
  ];
  const clear = start.clear.map(BigInt);
  const state = { kind: start.kind, texts: start.numbers.slice(), told: null, naive: null, view: null, held: null };
  const { seen, fit, drawScene, drawLens, drawGap, resized, size } = Drawing(start, state);
  const html = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  };

  /* -- the case ------------------------------------------------------------------------------------------- */

  /* What the textbook's formula makes of it: a·t² + b·t + c = 0 in doubles, with disc == 0 for a touch. */
  function naive() {
    const [cx, cy, r, ax, ay, bx, by_] = state.texts.map(Number);
    const [dx, dy] = state.kind === "ray" ? [bx, by_] : [bx - ax, by_ - ay];
    const fx = ax - cx, fy = ay - cy;
    const a = dx * dx + dy * dy, b = 2 * (fx * dx + fy * dy), c = fx * fx + fy * fy - r * r;
    const disc = b * b - 4 * a * c;
    const foot = -b / (2 * a), length = Math.sqrt(a);
    const at = t => [ax + t * dx, ay + t * dy];
    const found = { lone: a === 0, disc, roots: [], foot, at, point: at(foot) };
    found.distance = Math.hypot(found.point[0] - cx, found.point[1] - cy);
    found.half = disc < 0 ? null : Math.sqrt(disc) / 2 / length;
    if (a === 0) return found;
    if (disc === 0) found.roots = [foot];
    if (disc > 0) found.roots = [(-b - Math.sqrt(disc)) / (2 * a), (-b + Math.sqrt(disc)) / (2 * a)];
    found.kept = found.roots.filter(t => state.kind === "line" || (t >= 0 && (state.kind === "ray" || t <= 1)));
    return found;
  }

  function answers() {
    const { told, naive: rough } = state, points = n => `${n} point${n === 1 ? "" : "s"}`;
    if (state.kind === "ray") {
      const t = told.least === null || told.least === undefined ? "None" : `t = ${shortened(told.least)}`;
      return [t, rough.lone || !rough.kept.length ? "None" : `t = ${rough.kept[0]}`, told.kept.length ? 1 : 0,
        rough.lone ? 0 : Math.min(1, rough.kept.length)];
    }
    const exact = told.lone && state.kind === "line" ? "None" : points(told.kept.length);
    const inDoubles = rough.lone ? "None" : points(rough.kept.length);
    return [exact, inDoubles, told.lone && state.kind === "line" ? -1 : told.kept.length,
      rough.lone ? -1 : rough.kept.length];
  }

  function caseText() {
    const [cx, cy, r, ax, ay, bx, by_] = state.texts.map(text => text.trim());
    return `judge try ${start.problems[state.kind]} "${cx}, ${cy}, ${r}, (${ax}, ${ay}), (${bx}, ${by_})"`;
  }

  /* -- the words ------------------------------------------------------------------------------------------- */

  const BROKEN = {
    touch: "the line almost touches: not a valid input",
    start: "the beginning is almost on the circle: not a valid input",
    end: "the end is almost on the circle: not a valid input",
  };

  function tell() {
    const { told, naive: rough } = state, [exact, inDoubles, n, m] = answers();
    const differs = n !== m;
    const ray = state.kind === "ray";
    by("answer").replaceChildren(exact === "None" && !ray && told.lone ? "None: no line" : ray && exact === "None" ? "None: no hit" : exact);
    const badge = (text, kind) => html("span", { className: `badge ${kind}`, textContent: text });
    by("promise").replaceChildren(
      told.broken ? badge(BROKEN[told.broken], "warn") : badge(told.count === 1 ? "touches exactly" : "clear", "good"), " ",
      differs ? badge(`in doubles: ${inDoubles}`, "bad") : "");
    const rows = [["answer", exact, inDoubles, differs]];
    const pair = p => `(${p[0]}, ${p[1]})`;
    if (!told.lone) {
      const side = x => Math.sign(Number(x));
      rows.push(["discriminant Δ", told.delta, String(rough.disc / 4), side(told.delta) !== side(rough.disc)]);
      rows.push(["distance d", told.distance, String(rough.distance), false]);
      rows.push(["gap (d − r)/e", told.gap, String((rough.distance - Number(state.texts[2])) / Number(told.extent)), false]);
      rows.push(["foot, t", told.foot.t, String(rough.foot), false]);
      rows.push(["foot", pair(told.foot.point), pair(rough.point), false]);
      rows.push(["half-chord", told.half === null ? "none" : told.half, rough.half === null ? "none" : String(rough.half),
        (told.half === null) !== (rough.half === null)]);
      told.all.forEach((each, i) => {
        const t = rough.roots[i];
        rows.push([told.all.length > 1 ? `root ${i + 1}, t` : "touch, t", each.t, t === undefined ? "none" : String(t),
          t === undefined || Math.abs(t - Number(each.t)) > 1e-9 * Math.max(Math.abs(t), 1e-300)]);
        rows.push([told.all.length > 1 ? `point ${i + 1}` : "point", `${pair(each.point)}${each.kept ? "" : ", not counted"}`,
          t === undefined ? "none" : pair(rough.at(t)), t === undefined]);
      });
    }
    by("values").replaceChildren(...rows.map(([name, one, other, bad]) => {
      const row = html("tr", { className: bad ? "differs" : "" });
      const cells = [html("td", { textContent: one }), html("td", { textContent: other })];
      cells[0].dataset.says = "exactly";
      cells[1].dataset.says = other ? "in doubles" : "";
      row.append(html("th", { textContent: name, scope: "row" }), ...cells);
      return row;
    }));
    by("note").textContent = "Digits beyond the 24th are rounded. The formula is b² − 4ac with a touch where it is 0; "
      + "for Δ a quarter of it is shown. A red one is on the other side, or off by more than 1e-9.";
    by("case").textContent = caseText();
    by("noun").textContent = KINDS[state.kind][0];
  }

  function fields() {
    const [, first, second] = KINDS[state.kind];
    const names = ["cx", "cy", "r", `${first} x`, `${first} y`, `${second} x`, `${second} y`];
    by("numbers").replaceChildren(...names.map((name, i) => {
      const field = html("input", { value: state.texts[i], inputMode: "text", autocomplete: "off", spellcheck: false });
      field.dataset.at = String(i);
      field.addEventListener("input", () => {
        const texts = state.texts.slice();
        texts[i] = field.value;
        const fine = Exact.parse(field.value) !== null && !(i === 2 && Number(field.value) < 0);
        field.setAttribute("aria-invalid", String(!fine));
        if (fine) update(texts, { refit: false, refill: false });
      });
      return html("label", {}, name, field);
    }));
  }

  function update(texts, { refit = false, refill = true } = {}) {
    const told = Exact.analyse(texts, state.kind, clear);
    if (told === null) return;
    Object.assign(state, { texts, told });
    state.naive = naive();
    if (refit || !state.view) fit();
    if (refill) {
      for (const field of by("numbers").querySelectorAll("input")) {
        field.value = state.texts[Number(field.dataset.at)];
        field.setAttribute("aria-invalid", "false");
      }
    }
    drawScene();
    drawLens();
    drawGap();
    tell();
  }

  /* -- moving ---------------------------------------------------------------------------------------------- */

  function step() {
    const chosen = by("step").value;
    if (chosen !== "auto") return Number(chosen);
    return 10 ** Math.floor(Math.log10(state.view.size * 12));
  }

  /* The decimal text of a multiple of the step. */
  function onStep(value, by_) {
    const places = Math.max(0, Math.ceil(-Math.log10(by_) - 1e-9));
    const rounded = Math.round(value / by_) * by_;
    if (places > 100 || Math.abs(rounded) >= 1e15) return String(rounded);
    const text = rounded.toFixed(Math.min(places, 100));
    return text.includes(".") ? text.replace(/\.?0+$/, "") || "0" : text;
  }
  const clean = text => (text === "-0" ? "0" : text);

  function moved(id, at, precise) {
    const { cx, cy, r } = seen(), unit = precise || step(), texts = state.texts.slice();
    const set = (i, value) => { texts[i] = clean(onStep(value, unit)); };
    if (id === "R") set(2, Math.max(0, Math.hypot(...at)));
    if (id === "C") {
      set(0, cx + at[0]);
      set(1, cy + at[1]);
    }
    if (id === "A") {
      set(3, cx + at[0]);
      set(4, cy + at[1]);
    }
    if (id === "B") {
      const from = state.kind === "ray" ? [Number(state.texts[3]), Number(state.texts[4])] : [0, 0];
      set(5, cx + at[0] - from[0]);
      set(6, cy + at[1] - from[1]);
    }
    if (id === "C" && state.view) {  // the view stays where it is in the plane
      state.view.x -= Number(texts[0]) - cx;
      state.view.y -= Number(texts[1]) - cy;
    }
    if (texts.every(text => Exact.parse(text) !== null) && r >= 0) update(texts);
  }

  function pointed(event) {
    const box = by("scene").getBoundingClientRect(), { view } = state;
    const [w, h] = size();
    const px = (event.clientX - box.left) * (w / box.width), py = (event.clientY - box.top) * (h / box.height);
    return [view.x + (px - w / 2) * view.size, view.y - (py - h / 2) * view.size];
  }

  const scene = by("scene");
  scene.addEventListener("pointerdown", event => {
    const found = event.target.closest(".handle");
    state.held = found ? found.dataset.handle : "view";
    state.from = pointed(event);
    scene.setPointerCapture(event.pointerId);
    if (found) found.focus({ preventScroll: true });
    event.preventDefault();
  });
  scene.addEventListener("pointermove", event => {
    if (!state.held) return;
    const at = pointed(event);
    if (state.held === "view") {
      state.view.x -= at[0] - state.from[0];
      state.view.y -= at[1] - state.from[1];
      drawScene();
    } else moved(state.held, at);
  });
  for (const name of ["pointerup", "pointercancel"]) {
    scene.addEventListener(name, () => {
      state.held = null;
      drawScene();
    });
  }
  scene.addEventListener("wheel", event => {
    event.preventDefault();
    zoom(event.deltaY > 0 ? 1.15 : 1 / 1.15, pointed(event));
  }, { passive: false });
  scene.addEventListener("keydown", event => {
    const found = event.target.closest(".handle");
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!found || !way) return;
    event.preventDefault();
    nudge(found.dataset.handle, way, step() * (event.shiftKey ? 10 : 1));
  });

  /* By exactly so much: the numbers are decimals, and stay what they are beyond the last digit that moves. */
  function nudge(id, way, unit) {
    const texts = state.texts.slice(), { cx, cy } = seen();
    const add = (i, amount) => {
      if (!amount) return;
      const sum = Number(texts[i]) + amount;
      const places = [texts[i], String(amount)].map(text => {
        const [digits, exponent] = text.split("e");
        return Math.max(0, (digits.split(".")[1] || "").length - Number(exponent || 0));
      });
      texts[i] = Math.max(...places) > 100 ? String(sum) : clean(String(Number(sum.toFixed(Math.max(...places)))));
    };
    const [x, y] = [way[0] * unit, way[1] * unit];
    if (id === "R") {
      add(2, x || y);
      if (Number(texts[2]) < 0) texts[2] = "0";
    } else {
      const at = { C: 0, A: 3, B: 5 }[id];
      add(at, x);
      add(at + 1, y);
    }
    if (id === "C") {
      state.view.x -= Number(texts[0]) - cx;
      state.view.y -= Number(texts[1]) - cy;
    }
    update(texts);
  }

  function zoom(factor, around) {
    const { view } = state, [x, y] = around || [view.x, view.y];
    view.x = x + (view.x - x) * factor;
    view.y = y + (view.y - y) * factor;
    view.size *= factor;
    drawScene();
  }

  /* -- the rest of the page --------------------------------------------------------------------------------- */

  function choose(kind) {
    const texts = state.texts.slice();
    if ((kind === "ray") !== (state.kind === "ray")) {  // the same figure: B and A + D
      const sign = kind === "ray" ? -1 : 1;
      texts[5] = String(Number(texts[5]) + sign * Number(texts[3]));
      texts[6] = String(Number(texts[6]) + sign * Number(texts[4]));
    }
    state.kind = kind;
    fields();
    offer();
    update(texts);
  }

  function offer() {
    const fitting = EXAMPLES.filter(([, only]) => !Object.keys(only).length || only[state.kind]);
    const own = html("option", { value: "", textContent: start.called });
    by("examples").replaceChildren(own, ...fitting.map(([name]) => html("option", { value: name, textContent: name })));
  }

  function exampleOf(name) {
    const found = EXAMPLES.find(each => each[0] === name);
    if (!found) {
      return state.kind === start.kind ? start.numbers.slice() : state.texts;
    }
    const texts = found[2].slice();
    if (state.kind === "ray") {
      texts[5] = String(Number(texts[5]) - Number(texts[3]));
      texts[6] = String(Number(texts[6]) - Number(texts[4]));
    }
    return texts;
  }

  for (const kind of Object.keys(KINDS)) {
    const field = html("input", { type: "radio", name: "kind", value: kind, checked: kind === state.kind });
    field.addEventListener("change", () => choose(kind));
    by("kinds").append(html("label", {}, field, KINDS[kind][0]));
  }
  by("examples").addEventListener("change", () => update(exampleOf(by("examples").value), { refit: true }));
  by("step").append(html("option", { value: "auto", textContent: "what the zoom shows" }),
    ...["1", "0.1", "0.001", "1e-6", "1e-7", "1e-9", "1e-12", "1e-13"].map(text => html("option", { value: text, textContent: text })));
  by("in").addEventListener("click", () => zoom(1 / 1.5));
  by("out").addEventListener("click", () => zoom(1.5));
  by("fit").addEventListener("click", () => {
    fit();
    drawScene();
  });
  by("copy").addEventListener("click", async () => {
    const range = document.createRange();
    range.selectNodeContents(by("case"));
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    let done = false;
    try {
      await navigator.clipboard.writeText(by("case").textContent);
      done = true;
    } catch {
      done = document.execCommand("copy");
    }
    by("copy").textContent = done ? "Copied" : "Press Ctrl+C";
    by("copied").textContent = by("copy").textContent;
    setTimeout(() => { by("copy").textContent = "Copy"; }, 1500);
  });
  addEventListener("resize", resized);
  fields();
  offer();
  update(state.texts, { refit: true });
})();
