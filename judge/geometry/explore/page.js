"use strict";
/* The page of `judge try --open`: the case, what is said of it, and how it is moved. What is decided comes from `figure`. */
(() => {
  const start = JSON.parse(by("start").textContent);
  /* The address may hold a case: for each argument the texts of its numbers, as JSON. */
  if (location.hash.length > 1) {
    try {
      const given = JSON.parse(decodeURIComponent(location.hash.slice(1)));
      if (given.length === start.args.length) {
        start.cases.unshift(["The case it was opened with", given]);
        start.args = start.args.map((each, i) => ({ ...each, value: given[i] }));
      }
    } catch { /* it is none */ }
  }
  const flat = value => (Array.isArray(value) ? value.flatMap(flat) : [value]);
  const textsOf = args => args.flatMap(each => flat(each.value));
  const state = { args: start.args, texts: textsOf(start.args), numbers: null, told: null, rough: null, view: null, held: null };
  const { grips, anchor, float, fit, drawScene, drawLens, drawGap, resized, size } = Drawing(start, state);
  const html = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  };

  /* -- the words ------------------------------------------------------------------------------------------- */

  /* The arguments as Python writes them. */
  function caseText() {
    let next = 0;
    const text = (value, list) => {
      if (!Array.isArray(value)) return state.texts[next++].trim();
      const inner = value.map(each => text(each, false)).join(", ");
      return list ? `[${inner}]` : `(${inner})`;
    };
    return `judge try ${start.problem} "${state.args.map(each => text(each.value, each.list)).join(", ")}"`;
  }

  const badge = (text, kind) => html("span", { className: `badge ${kind}`, textContent: text });
  const invalid = what => badge(`${what}: not a valid input`, "warn");
  function tell() {
    const { told, rough } = state, exactly = told.decisions.filter(each => each.side === 0).map(each => each.says);
    by("answer").textContent = told.answer || "no answer";
    const differs = rough.answer !== told.answer && told.answer !== shortly(rough.answer);
    by("promise").replaceChildren(
      told.broken ? invalid(told.broken)
        : told.decisions.length ? badge([...new Set(exactly)].slice(0, 2).join(", ") || "clear", "good") : "", " ",
      differs ? badge(`in doubles: ${rough.answer || "no answer"}`, "bad") : "");
    const rows = [["answer", told.answer, rough.answer, differs]];
    const shown = all => (all.length > 1 ? `(${all.join(", ")})` : all[0]);
    const inDoubles = new Map(rough.rows);
    for (const [name, all] of told.rows) {
      const other = inDoubles.get(name);
      const off = !other || all.some((x, i) => far(Number(x), Number(other[i]), name.startsWith("discriminant")));
      rows.push([name, shown(all), other ? shown(other) : "none", off]);
    }
    const close = [...told.decisions].sort((x, y) => Math.abs(x.part) - Math.abs(y.part)).slice(0, 8);
    for (const each of close) {
      const other = rough.decisions[told.decisions.indexOf(each)];
      rows.push([each.says, `${each.gap}·e`, other ? `${other.gap}·e` : "not asked", !other || other.side !== each.side]);
    }
    by("values").replaceChildren(...rows.map(([name, one, other, bad]) => {
      const row = html("tr", { className: bad ? "differs" : "" });
      const cells = [html("td", { textContent: one }), html("td", { textContent: other })];
      cells[0].dataset.says = "exactly";
      cells[1].dataset.says = other ? "in doubles" : "";
      row.append(html("th", { textContent: name, scope: "row" }), ...cells);
      return row;
    }));
    by("case").textContent = caseText();
  }
  const far = (x, y, signs) => (signs ? Math.sign(x) !== Math.sign(y) : !(Math.abs(x - y) <= 1e-9 * Math.max(Math.abs(x), 1e-300)));
  /* An answer with its numbers cut as the exact ones are, where they agree in nine digits. */
  const shortly = text => {
    const numbers = /-?\d+\.?\d*…?(e[+-]\d+)?/g, mine = state.told.answer.match(numbers) || [];
    let next = 0;
    return text.replace(numbers, found => {
      const other = mine[next++];
      return other !== undefined && !far(Number(other.replace("…", "")), Number(found.replace("…", ""))) ? other : found;
    });
  };

  const PARTS = { 2: ["x", "y"], 3: ["x", "y", "r"] };
  function fields() {
    let next = 0;
    const made = [];
    const add = (name, value, list) => {
      if (Array.isArray(value)) {
        const parts = list ? value.map((_, i) => i) : Array.isArray(value[0]) ? ["O", "D"] : PARTS[value.length];
        value.forEach((each, i) => add(`${name} ${parts[i]}`, each, false));
      } else made.push(field(name, next++));
    };
    for (const each of state.args) add(each.name, each.value, each.list);
    by("numbers").replaceChildren(...made);
  }

  function field(name, i) {
    const made = html("input", { value: state.texts[i], inputMode: "text", autocomplete: "off", spellcheck: false });
    made.dataset.at = String(i);
    made.addEventListener("input", () => {
      const texts = state.texts.slice();
      texts[i] = made.value;
      const fine = (!start.whole || /^\s*[+-]?\d+\s*$/.test(made.value)) && update(texts, { refill: false });
      made.setAttribute("aria-invalid", String(!fine));
    });
    return html("label", {}, name, made);
  }

  /* What is said of a number that is not within its bounds, which are fractions; empty where all are. */
  function outside(texts) {
    let next = 0;
    for (const { name, value, bounds } of state.args) {
      for (const i of flat(value).keys()) {
        const text = texts[next++], [number, shift] = Exact.parse(text);
        const ends = bounds[i % bounds.length].map(each => `${each}/1`.split("/").map(BigInt));
        const [below, above] = ends.map(([n, d]) => number * d - (n << BigInt(shift)));
        const [low, high] = ends.map(([n, d]) => Number(n) / Number(d));
        if (below < 0n || above > 0n) return `${name} has ${text.trim()}, outside ${low} to ${high}`;
      }
    }
    return "";
  }

  /* Whether these numbers are a case, which is shown then. */
  function update(texts, { refit = false, refill = true } = {}) {
    const run = arithmetic => {
      const numbers = arithmetic(texts);
      return numbers && { numbers, told: figure(start.kind, start, numbers, state.args.map(each => each.value)) };
    };
    const exact = run(Exact.arithmetic);
    const wrong = exact && outside(texts);
    if (wrong) by("promise").replaceChildren(invalid(wrong));
    if (!exact || wrong) return false;
    Object.assign(state, exact, { texts, rough: run(Doubles.arithmetic).told });
    if (refit || !state.view) fit();
    if (refill) {
      for (const each of by("numbers").querySelectorAll("input")) {
        each.value = state.texts[Number(each.dataset.at)];
        each.setAttribute("aria-invalid", "false");
      }
    }
    drawScene();
    drawLens();
    drawGap();
    tell();
    return true;
  }

  /* -- moving ---------------------------------------------------------------------------------------------- */

  function step() {
    const chosen = by("step").value, auto = 10 ** Math.floor(Math.log10(state.view.size * 12));
    return chosen !== "auto" ? Number(chosen) : start.whole ? Math.max(1, auto) : auto;
  }

  /* The decimal text of a multiple of the step. */
  function onStep(value, unit) {
    const places = Math.max(0, Math.ceil(-Math.log10(unit) - 1e-9)), rounded = Math.round(value / unit) * unit;
    if (places > 100 || Math.abs(rounded) >= 1e15) return start.whole ? String(BigInt(rounded)) : String(rounded);
    const text = rounded.toFixed(Math.min(places, 100));
    return clean(text.includes(".") ? text.replace(/\.?0+$/, "") || "0" : text);
  }
  const clean = text => (text === "-0" ? "0" : text);

  /* Set the numbers of a grip, which `change` makes of slot and axis; the view stays where it is in the plane. */
  function set(each, change) {
    const texts = state.texts.slice(), before = anchor().map(float);
    if (each.slot !== undefined) {
      const text = change(each.slot, null);
      texts[each.slot] = Number(text) < 0 ? "0" : text;
    } else each.slots.forEach((slot, axis) => { texts[slot] = change(slot, axis); });
    if (!update(texts)) return;
    const after = anchor().map(float);
    if (after[0] !== before[0] || after[1] !== before[1]) {
      state.view.x -= after[0] - before[0];
      state.view.y -= after[1] - before[1];
      drawScene();
    }
  }

  const held = id => grips().find(each => each.id === id);
  function moved(id, at) {
    const each = held(id), unit = step(), origin = anchor().map(float);
    if (!each) return;
    const from = each.from ? each.from.map(float) : [0, 0];
    set(each, (_, axis) => (axis === null ? onStep(Math.hypot(at[0] - each.centre[0], at[1] - each.centre[1]), unit)
      : onStep(origin[axis] + at[axis] - from[axis], unit)));
  }

  /* By exactly so much: the numbers are decimals, and stay what they are beyond the last digit that moves. */
  function nudge(id, [x, y], unit) {
    set(held(id), (slot, axis) => {
      const amount = (axis === null ? x || y : [x, y][axis]) * unit, text = state.texts[slot];
      if (!amount) return text;
      if (/^[+-]?\d+$/.test(text) && Number.isInteger(amount)) return String(BigInt(text.replace(/^\+/, "")) + BigInt(amount));
      const places = [text, String(amount)].map(each => {
        const [digits, exponent] = each.split("e");
        return Math.max(0, (digits.split(".")[1] || "").length - Number(exponent || 0));
      });
      const sum = Number(text) + amount;
      return Math.max(...places) > 100 ? String(sum) : clean(String(Number(sum.toFixed(Math.max(...places)))));
    });
  }

  function pointed(event) {
    const box = by("scene").getBoundingClientRect(), { view } = state, [w, h] = size();
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

  function zoom(factor, around) {
    const { view } = state, [x, y] = around || [view.x, view.y];
    view.x = x + (view.x - x) * factor;
    view.y = y + (view.y - y) * factor;
    view.size *= factor;
    drawScene();
  }

  /* -- the rest of the page --------------------------------------------------------------------------------- */

  by("examples").append(...start.cases.map(([name], i) => html("option", { value: String(i), textContent: name })));
  function choose(number) {
    by("examples").value = String(number);
    state.args = start.args.map((each, i) => ({ ...each, value: start.cases[number][1][i] }));
    state.texts = textsOf(state.args);
    fields();
    return update(state.texts, { refit: true });
  }
  by("examples").addEventListener("change", () => choose(Number(by("examples").value)));
  const steps = ["1", ...(start.whole ? ["10", "1000"] : ["0.1", "0.001", "1e-6", "1e-7", "1e-9", "1e-12", "1e-13"])];
  by("step").append(html("option", { value: "auto", textContent: "what the zoom shows" }),
    ...steps.map(text => html("option", { value: text, textContent: text })));
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
  start.cases.some((_, number) => choose(number));
})();
