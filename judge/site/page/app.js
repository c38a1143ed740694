/* The page: katas, a program and what the judge says of it, cards, progress. Python runs in python.js.

   Whatever a program or a person wrote goes in as text. HTML is put in only where `judge site` made it. */

const $ = (name, from = document) => from.querySelector(name);
function el(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children.filter(each => each !== null && each !== undefined && each !== ""));
  return made;
}
function drawn(svg, words) {
  const picture = el("img", { alt: words, src: URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })) });
  picture.onload = () => URL.revokeObjectURL(picture.src);
  return picture;
}
const html = (name, className, text) => el(name, { className, innerHTML: text });
const button = (text, act, className = "") => el("button", { type: "button", className, onclick: act }, text);
const counted = (n, noun) => `${n.toLocaleString("en")} ${noun}${n === 1 ? "" : "s"}`;
const json = async path => (await fetch(path)).json();
async function bytes(path) {
  const found = await fetch(path);
  if (!found.ok) throw new Error(`${path}: ${found.status}`);
  return new Uint8Array(await found.arrayBuffer());
}
const main = $("#main"), state = $("#state");

/* -- what is kept in this browser ---------------------------------------------------------------------------- */

const KEY = "judge.progress.1", EMPTY = { katas: {}, cards: {}, days: {}, last: "" };
let kept = read(), refused = false;
function read() {
  try {
    return checked(JSON.parse(localStorage.getItem(KEY) || "null")) || structuredClone(EMPTY);
  } catch {
    return structuredClone(EMPTY);
  }
}
function checked(found) {
  const table = each => each && typeof each === "object" && !Array.isArray(each);
  if (!table(found) || !table(found.katas) || !table(found.cards)) return null;
  const katas = Object.entries(found.katas).filter(([, each]) => table(each) && typeof each.source === "string");
  const cards = Object.entries(found.cards).filter(([, each]) => table(each));
  return { katas: Object.fromEntries(katas), cards: Object.fromEntries(cards), days: table(found.days) ? found.days : {}, last: String(found.last || "") };
}
function keep() {
  try {
    localStorage.setItem(KEY, JSON.stringify(kept));
    refused = false;
  } catch {
    if (!refused) say("This browser keeps nothing: storage is full or refused. Export your progress before you leave.", "failed");
    refused = true;
  }
}
const mine = kata => kept.katas[kata.id] ||= { source: kata.stub, tries: 0, hints: 0, stars: 0, solved: "" };
/* What is kept here, joined with the terminal's own history where `judge site --open` serves it. */
let terminal = { katas: {}, days: [], skills: [] };
function standing(kata) {
  const both = [kept.katas[kata.id], terminal.katas[kata.id]].filter(Boolean), all = key => both.map(each => each[key] || 0);
  return { tries: all("tries").reduce((a, b) => a + b, 0), hints: Math.max(0, ...all("hints")), stars: Math.max(0, ...all("stars")), solved: all("solved").filter(Boolean).sort()[0] || "" };
}
const solved = kata => Boolean(standing(kata).solved);
const stars = kata => (kata.levels ? "★".repeat(standing(kata).stars) : "") || (solved(kata) ? "✓" : "");
const dayOf = when => new Date(when).toLocaleDateString("sv"); // 2026-11-29, where the person is

function say(text, kind = "") {
  state.textContent = text;
  state.className = kind;
}

/* -- Python in a worker -------------------------------------------------------------------------------------- */

const SILENCE = 20_000; // milliseconds without a word, after which a program is stuck inside one call
const python = {
  worker: null, ready: null, opened: new Map(), run: null, runs: 0, timer: 0,

  start() {
    this.opened = new Map();
    this.ready = (async () => {
      const text = `const BASE = ${JSON.stringify(new URL("./", location.href).href)};\n${await (await fetch("python.js")).text()}`;
      const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
      this.worker = new Worker(address, { type: "module" });
      await new Promise((resolve, reject) => {
        this.worker.onmessage = ({ data }) => (data.ready ? resolve() : this.hear(data));
        this.worker.onerror = event => reject(new Error(event.message || "the worker did not start"));
      });
      URL.revokeObjectURL(address);
      say("Ready", "ready");
      Promise.all(["hypothesis", "sortedcontainers"].map(name => bytes(`wheels/${name}.whl`)))
        .then(wheels => this.worker.postMessage({ wheels })).catch(() => {}); // the search does without
    })();
    this.ready.catch(fault => say(`Python did not start: ${fault.message}. Reload the page.`, "failed"));
    return this.ready;
  },

  /* Hand a kata to the worker, once; a promise that keeps when the worker has it. */
  open(kata) {
    const { opened } = this;
    if (!opened.has(kata.id)) {
      opened.set(kata.id, (async () => {
        await this.ready;
        this.worker.postMessage({ kata: kata.id, archive: await bytes(`kata/${kata.id}.zip`) });
      })());
      opened.get(kata.id).catch(() => opened.delete(kata.id));
    }
    return opened.get(kata.id);
  },

  async judge(kata, source, hear) {
    const id = ++this.runs;
    this.run = { id, hear };
    await this.open(kata);
    if (this.run?.id !== id) return;
    this.watch();
    this.worker.postMessage({ run: id, kata: kata.id, source });
  },

  hear(said) {
    if (said.fault && !said.run) return say(`This kata could not be read: ${said.fault}`, "failed");
    if (!this.run || said.run !== this.run.id) return undefined;
    this.watch();
    if (said.alive) return undefined;
    const { hear } = this.run;
    if (said.last || said.fault) this.over();
    return hear(said.fault ? { fault: `The judge failed, not your program: ${said.fault}` } : said);
  },

  watch() {
    clearTimeout(this.timer);
    const happened = "Stopped: one call did not end. An endless loop inside a call such as 10 ** 10 ** 9?";
    this.timer = setTimeout(() => this.stop({ told: { verdict: "TLE", meaning: "Time limit exceeded", happened } }), SILENCE);
  },
  over() {
    clearTimeout(this.timer);
    this.run = null;
  },
  stop(said) {
    const { run } = this;
    this.over();
    this.worker?.terminate();
    say("Starting Python again…");
    this.start();
    run?.hear({ last: true, ...said });
  },
};

/* -- the editor ---------------------------------------------------------------------------------------------- */

async function editor(source, changed, run) {
  const box = el("div", { className: "editor" }), wide = matchMedia("(min-width: 40rem)").matches && !matchMedia("(pointer: coarse)").matches;
  if (wide && site.editor && (await script("ace/ace.js"))) {
    const { ace } = window, dark = matchMedia("(prefers-color-scheme: dark)");
    ace.config.set("useStrictCSP", true);
    ace.config.set("basePath", "ace");
    const area = el("div");
    box.append(area);
    const made = ace.edit(area, { value: source, mode: "ace/mode/python", showPrintMargin: false, useSoftTabs: true, tabSize: 4, useWorker: false, minLines: 14, maxLines: 36 });
    const theme = () => made.setTheme(`ace/theme/${dark.matches ? "github_dark" : "github_light_default"}`);
    theme();
    dark.addEventListener("change", theme);
    made.textInput.getElement().setAttribute("aria-label", "Your program. Escape, then Tab, leaves it.");
    made.commands.addCommand({ name: "leave", bindKey: "Esc", exec: () => $("#run").focus() });
    made.commands.addCommand({ name: "run", bindKey: { win: "Ctrl-Enter", mac: "Cmd-Enter" }, exec: run });
    made.on("change", () => changed(made.getValue()));
    return { box, set: text => made.setValue(text, -1), mark: line => made.gotoLine(line, 0, true), fit: () => made.resize() };
  }
  const area = el("textarea", { value: source, spellcheck: false, autocapitalize: "off", autocomplete: "off" });
  area.setAttribute("aria-label", "Your program");
  area.oninput = () => changed(area.value);
  area.onkeydown = event => {
    const put = text => {
      event.preventDefault();
      area.setRangeText(text, area.selectionStart, area.selectionEnd, "end");
      changed(area.value);
    };
    if (event.key === "Tab" && !event.shiftKey) put("    ");
    else if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) run();
    else if (event.key === "Enter") {
      const line = area.value.slice(0, area.selectionStart).split("\n").pop();
      put(`\n${line.match(/^ */)[0]}${line.trimEnd().endsWith(":") ? "    " : ""}`);
    } else if (event.key === "Escape") $("#run").focus();
  };
  box.append(area);
  return { box, set: text => { area.value = text; }, mark: () => {}, fit: () => {} };
}
const scripts = new Map();
function script(path) {
  if (!scripts.has(path)) {
    scripts.set(path, new Promise(resolve => {
      const sheets = ["ace", "theme/github_light_default", "theme/github_dark"].map(name => el("link", { rel: "stylesheet", href: `ace/${name}.css` }));
      document.head.append(...sheets, el("script", { src: path, onload: () => resolve(true), onerror: () => resolve(false) }));
    }));
  }
  return scripts.get(path);
}

/* -- a kata -------------------------------------------------------------------------------------------------- */

async function showKata(kata) {
  const page = await json(`kata/${kata.id}.json`), own = mine(kata);
  kept.last = kata.id;
  keep();
  const result = el("section", { className: "card result", id: "result", hidden: true, tabIndex: -1 });
  result.setAttribute("aria-label", "The result");
  const help = el("section", { className: "card", hidden: true }), task = html("article", "card task", page.statement);
  const run = button("Run", () => judge(), "main"), stop = button("Stop", () => python.stop({ fault: "Stopped." }));
  Object.assign(run, { id: "run", title: "Ctrl+Enter" });
  stop.hidden = true;
  const hint = button("", () => showHint());
  const reset = button("Start over", () => {
    if (!confirm("Put the first text back? What you wrote is gone then.")) return;
    code.set(kata.stub);
    own.source = kata.stub;
    keep();
  });
  const code = await editor(own.source, text => { own.source = text; keep(); }, () => judge());
  const doing = el("span", { className: "quiet small" });
  doing.setAttribute("role", "status");
  const work = el("div", { className: "work" },
    el("section", { className: "card" }, code.box, el("div", { className: "row" }, run, stop, page.hints.length ? hint : "", reset,
      page.explore ? el("a", { className: "button", href: `explore/${kata.id}.html`, target: "_blank", rel: "noopener" }, "Explore") : "", doing)), result, help);
  task.append(button("Write it", () => work.scrollIntoView(), "jump"));
  main.replaceChildren(el("div", { className: "kata" }, task, work));
  code.fit();

  const label = () => {
    hint.textContent = own.hints < page.hints.length ? `Hint ${own.hints + 1} of ${page.hints.length}` : "Solution";
    hint.hidden = own.hints >= page.hints.length && solved(kata);
  };
  const helped = () => {
    const shown = page.hints.slice(0, own.hints).map(each => el("div", { className: "hint" }, el("h3", {}, each.title), html("div", "", each.html)));
    if (own.gaveUp || solved(kata)) {
      shown.push(el("div", { className: "hint" }, el("h3", {}, "The model solution"), html("div", "", page.solution.html), el("pre", {}, page.solution.source)));
    }
    help.replaceChildren(...shown);
    help.hidden = !shown.length;
    label();
  };
  function showHint() {
    if (own.hints < page.hints.length) own.hints += 1;
    else if (confirm("See the model solution? You have not solved this kata yet.")) own.gaveUp = true;
    keep();
    helped();
    help.lastElementChild?.scrollIntoView({ block: "nearest" });
  }
  async function judge() {
    if (run.disabled) return;
    run.disabled = true;
    stop.hidden = false;
    doing.textContent = "Judging";
    doing.classList.add("busy");
    const hear = said => {
      if (said.progress) {
        doing.textContent = `${said.progress[0].toLocaleString("en")} of ${counted(said.progress[1], "case")}`;
        return;
      }
      if (said.fault) result.replaceChildren(el("p", {}, said.fault));
      else draw(said.told);
      result.hidden = false;
      doing.textContent = said.last || said.fault ? "" : "Looking for the smallest failing case";
      if (!said.last && !said.fault) return;
      doing.classList.remove("busy");
      run.disabled = false;
      stop.hidden = true;
      if (said.told) noted(said.told);
    };
    await python.judge(kata, own.source, hear).catch(() => {
      python.over();
      hear({ fault: "This kata could not be fetched. Are you offline?" });
    });
  }
  function noted(told) {
    const today = dayOf(Date.now());
    kept.days[today] = (kept.days[today] || 0) + 1;
    own.tries += 1;
    own.stars = Math.max(own.stars, told.stars?.length || 0);
    if (told.solved) own.solved ||= new Date().toISOString();
    keep();
    helped();
  }
  function draw(told) {
    const parts = [el("h2", { className: `verdict ${told.verdict === "AC" ? "AC" : ""}` },
      el("span", { className: "badge" }, told.verdict), told.meaning, told.stars ? el("span", { className: "mark" }, told.stars) : "")];
    if (told.happened) parts.push(el("p", {}, told.happened));
    if (told.source?.length) parts.push(el("pre", {}, told.source.join("\n")));
    if (told.case) {
      const facts = el("dl");
      if (told.input?.length) facts.append(el("dt", {}, "input"), el("dd", {}, ...told.input.map(each => el("span", {}, each))));
      for (const [label_, text] of told.facts || []) facts.append(el("dt", {}, label_), el("dd", { className: label_ }, text));
      const shown = el("div", { className: "case" }, el("div", {}, el("h3", {}, told.case), facts));
      for (const each of told.drawings || []) shown.append(el("figure", {}, drawn(each.svg, told.drawn), el("figcaption", {}, each.title)));
      parts.push(shown);
    }
    if (told.mistake) parts.push(el("div", { className: "mistake" }, el("h3", {}, told.mistake), ...told.advice.map(each => el("p", {}, each))));
    if (told.fails?.length) parts.push(el("p", { className: "quiet small" }, `Fails: ${told.fails.join(", ")}${told.more ? `, ${told.more} more` : ""}`));
    const next = following(kata), actions = el("div", { className: "row" });
    if (told.solved && next) actions.append(el("a", { className: "button main", href: `#${next.id}` }, `Next: ${next.title}`));
    if (told.explore?.length > 2 && page.explore) actions.append(el("a", { className: "button", href: `explore/${kata.id}.html#${encodeURIComponent(told.explore)}`, target: "_blank", rel: "noopener" }, "Drag this case"));
    if (told.line) actions.append(button(`Go to line ${told.line}`, () => code.mark(told.line)));
    if (told.last) parts.push(el("p", {}, told.last));
    if (actions.childElementCount) parts.push(actions);
    result.replaceChildren(...parts);
  }
  helped();
  python.open(kata).then(() => ahead(following(kata)), () => say("This kata could not be fetched. Are you offline?", "failed"));
}
/* The files of the next kata, which the service worker keeps: it opens at once, and without a network. */
const ahead = kata => kata && Promise.allSettled(["json", "zip", ...(kata.figure ? ["svg"] : [])].map(end => fetch(`kata/${kata.id}.${end}`)));
const path = () => [...new Set(site.sets.flatMap(set => set.katas))].map(id => byId.get(id)).filter(kata => kata && !kata.elsewhere);
function following(kata) {
  const all = path(), at = all.indexOf(kata) + 1;
  return [...all.slice(at), ...all.slice(0, at)].find(each => each !== kata && !solved(each)) || null;
}

/* -- the other pages ----------------------------------------------------------------------------------------- */

function bar(done, all) {
  const filled = el("i"), made = el("div", { className: "bar" }, filled);
  filled.style.width = `${(100 * done) / Math.max(all, 1)}%`;
  made.setAttribute("aria-hidden", "true");
  return made;
}
function showKatas() {
  const all = path(), done = site.katas.filter(solved).length;
  const last = byId.get(kept.last), next = last && !solved(last) ? last : (last && following(last)) || all.find(kata => !solved(kata));
  const tile = kata => {
    const mark = el("span", { className: `mark ${solved(kata) ? "done" : ""}` }, stars(kata));
    const picture = el("span", { className: "figure" }, kata.figure ? el("img", { src: `kata/${kata.id}.svg`, alt: "", loading: "lazy" }) : "{ }");
    const inner = [picture, el("b", {}, kata.title), mark, el("span", { className: "quiet small" }, kata.elsewhere || kata.summary)];
    const className = `tile ${solved(kata) ? "solved" : ""} ${kata === next ? "here" : ""}`;
    return el("li", {}, kata.elsewhere ? el("div", { className }, ...inner) : el("a", { className, href: `#${kata.id}` }, ...inner));
  };
  main.replaceChildren(el("section", { className: "hero" },
    el("h1", {}, site.title),
    el("p", { className: "quiet" }, "Write one Python function. It is tested on hundreds of cases, here in this tab. If it fails, you see the smallest case that fails, a picture, and the name of the mistake."),
    el("div", { className: "row" }, bar(done, site.katas.length), el("span", {}, `${done} of ${counted(site.katas.length, "kata")}`)),
    el("div", { className: "row" }, next && el("a", { className: "button main", href: `#${next.id}` }, standing(next).tries ? `Go on: ${next.title}` : `Start: ${next.title}`),
      el("a", { className: "button", href: "explore/" }, "Explore"))),
  ...site.sets.map(set => el("section", { className: "set" },
    el("h2", {}, set.title), el("p", { className: "quiet" }, set.about),
    el("ul", { className: "tiles path" }, ...set.katas.map(id => tile(byId.get(id)))))));
}

/* The number that a person types: 4, 0.5, 1e-9 or 2/3; NaN of anything else. */
function numberOf(text) {
  if (!/^[+-]?\d+(\.\d*)?(e[+-]?\d+)?$|^[+-]?\d+\/\d+$/i.test(text)) return NaN;
  const [above, below = 1] = text.split("/").map(Number);
  return above / below;
}
/* Whether what is typed is the card's answer; null where it can be none. */
function isRight({ number, answer }, typed) {
  const bare = text => text.toLowerCase().replace(/[\s,;>→]+/g, "");
  if (!number) return bare(typed) ? bare(typed) === bare(answer) : null;
  const found = numberOf(typed.trim().replace(number.unit, "").trim()), expected = numberOf(number.answer);
  return Number.isNaN(found) ? null : Math.abs(found - expected) <= (number.within + 1e-12) * Math.abs(expected);
}
async function showQuiz(name) {
  const all = await json("quiz.json"), sets = site.sets.filter(set => all.some(card => card.sets.includes(set.name)));
  const set = sets.find(each => each.name === name) || sets.find(each => each.katas.includes(kept.last)) || sets[0];
  const rank = card => kept.cards[card.key]?.known || 0;
  const round = all.filter(card => card.sets.includes(set.name)).sort((a, b) => rank(a) - rank(b)).slice(0, 10);
  const choose = el("nav", { className: "row" }, ...sets.map(each => el("a", { className: `button ${each === set ? "main" : ""}`, href: `#quiz/${each.name}` }, each.title)));
  choose.setAttribute("aria-label", "Sets of cards");
  const box = el("section", { className: "card" });
  main.replaceChildren(el("div", { className: "quiz" }, el("h1", {}, `Quiz: ${set.title}`), choose, box));
  let known = 0;
  const ask = at => {
    if (at === round.length) {
      box.replaceChildren(el("h2", {}, `${known} of ${counted(round.length, "card")} known`), el("p", {}, ""), button("Ten more", () => showQuiz(set.name), "main"));
      return;
    }
    const card = round[at], over = el("div");
    const rated = right => {
      known += right;
      kept.cards[card.key] = { known: right ? rank(card) + 1 : 0, when: new Date().toISOString() };
      keep();
    };
    const onward = () => button(at + 1 < round.length ? "Next card" : "Finish", () => ask(at + 1), "main");
    const answered = why => over.replaceChildren(card.drawn ? drawn(card.drawn, "The figure with the answer") : "", ...[why, card.why].filter(Boolean).map(each => el("p", {}, each)), el("br"), el("div", { className: "row" }, onward()));
    const parts = [el("p", { className: "quiet small" }, `Question ${at + 1} of ${round.length}`), el("p", { className: "front" }, card.front), ...card.given.map(each => el("p", {}, each))];
    if (card.svg) parts.push(drawn(card.svg, "The figure of the question"));
    if (card.options.length) {
      const options = card.options.map(({ text, right, why }) => {
        const made = button(text, () => {
          options.forEach((each, i) => {
            each.disabled = true;
            if (card.options[i].right) each.classList.add("right");
          });
          if (!right) made.classList.add("wrong");
          rated(right);
          answered(right ? "Right." : why);
        });
        return made;
      });
      parts.push(el("div", { className: card.options.every(({ text }) => text.length < 6) ? "options row" : "options" }, ...options));
    } else if (card.typed) {
      const field = el("input", { type: "text", autocomplete: "off" }), said = el("span", { className: "quiet small" }, card.typed);
      const form = el("form", { className: "row answer" }, el("label", {}, "Answer ", field, card.number?.unit && ` ${card.number.unit}`), button("Enter", () => form.requestSubmit(), "main"), said);
      form.onsubmit = event => {
        event.preventDefault();
        const right = isRight(card, field.value);
        if (right === null) return void said.replaceChildren(`Write ${card.typed}.`);
        form.classList.add(right ? "right" : "wrong");
        for (const each of form.querySelectorAll("input, button")) each.disabled = true;
        rated(right);
        answered(right ? "Right." : `It is ${card.answer}.`);
      };
      parts.push(form);
    } else {
      parts.push(button("Show the answer", event => {
        event.target.remove();
        over.replaceChildren(el("p", { className: "front" }, card.answer), ...[card.why].filter(Boolean).map(each => el("p", {}, each)), el("br"),
          el("div", { className: "row" }, button("I knew it", () => { rated(true); ask(at + 1); }, "main"), button("I did not", () => { rated(false); ask(at + 1); })));
      }, "main"));
    }
    box.replaceChildren(...parts, over);
    $("input", box)?.focus();
  };
  ask(0);
}

/* Katas solved by day, from the first day to today; nothing where all is of today. */
function curve(done) {
  const days = done.map(kata => dayOf(standing(kata).solved)).sort(), number = day => Math.round(Date.parse(day) / 86_400_000);
  if (!days.length) return "";
  const first = number(days[0]) - 1, last = number(dayOf(Date.now())), x = day => 10 + (380 * (number(day) - first)) / (last - first), y = n => 140 - (110 * n) / days.length;
  const steps = days.map((day, i) => `H${x(day).toFixed(1)}V${y(i + 1).toFixed(1)}`).join("");
  const words = `Katas solved by day: ${days.length} since ${days[0]}`;
  return el("figure", { className: "curve" }, drawn(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 160"><style>text{font:13px system-ui,sans-serif;fill:#52525b}path{fill:none;stroke:#16a34a;stroke-width:3}.axis{stroke:#a1a1aa;stroke-width:1}@media(prefers-color-scheme:dark){text{fill:#a1a1aa}}</style><path class="axis" d="M10 140H390"/><path d="M10 140${steps}H390"/><text x="10" y="157">${days[0]}</text><text x="390" y="157" text-anchor="end">today</text><text x="390" y="${y(days.length) - 8}" text-anchor="end">${days.length}</text></svg>`, words), el("figcaption", {}, "Katas solved by day"));
}
function showProgress() {
  const tried = site.katas.filter(kata => standing(kata).tries), done = tried.filter(solved);
  const rows = tried.map(kata => {
    const { tries, hints, solved: when } = standing(kata);
    return el("tr", {}, el("td", {}, kata.elsewhere ? kata.title : el("a", { href: `#${kata.id}` }, kata.title)), el("td", {}, stars(kata) || "open"),
      el("td", {}, counted(tries, "run")), el("td", {}, counted(hints, "hint")), el("td", {}, when && dayOf(when)));
  });
  const skills = new Set(site.katas.flatMap(kata => kata.skills)), week = Array.from({ length: 7 }, (_, ago) => dayOf(Date.now() - ago * 86_400_000));
  const shown = new Set([...terminal.skills, ...site.katas.filter(kata => kept.katas[kata.id]?.solved).flatMap(kata => kata.skills)].filter(each => skills.has(each)));
  const days = week.filter(day => kept.days[day] || terminal.days.includes(day));
  const levelled = site.katas.filter(kata => kata.levels);
  const tiles = [[`${done.length} of ${site.katas.length}`, "katas solved"], [`${levelled.filter(kata => standing(kata).stars > 1).length} of ${levelled.length}`, "★★"],
    [`${shown.size} of ${skills.size}`, site.topics.length ? `skills of ${site.topics.join(" and ")}` : "skills shown"], [`${days.length} of 7`, "days practised"]];
  const file = el("input", { type: "file", accept: ".json,application/json", hidden: true });
  file.onchange = async () => {
    try {
      const found = checked(JSON.parse(await file.files[0].text()));
      if (!found) throw new Error();
      kept = found;
      keep();
      showProgress();
    } catch {
      alert("This is not a progress file of this page. Choose the .json file that Export wrote.");
    }
  };
  main.replaceChildren(el("section", { className: "card" }, el("h1", {}, "Your progress"),
    el("p", { className: "quiet" }, "What you do here is kept in this browser alone. Export it before you clear the browser's data or change the machine."),
    el("dl", { className: "figures" }, ...tiles.map(([figure, label]) => el("div", {}, el("dt", {}, label), el("dd", {}, figure)))), curve(done), el("br"),
    rows.length ? el("div", { className: "wide" }, el("table", {}, el("tbody", {}, ...rows))) : el("p", {}, "No kata was tried yet."), el("br"),
    el("div", { className: "row" }, button("Export", () => {
      const address = URL.createObjectURL(new Blob([JSON.stringify(kept, null, 1)], { type: "application/json" }));
      el("a", { href: address, download: "judge-progress.json" }).click();
      setTimeout(() => URL.revokeObjectURL(address), 1000);
    }), button("Import", () => file.click()), file)));
}

/* -- the way from an address to a page ------------------------------------------------------------------------ */

let site, byId;
async function show() {
  const [name, part] = decodeURIComponent(location.hash.slice(1)).split("/"), kata = byId.get(name);
  if (python.run) python.stop({ fault: "Stopped." });
  terminal = { katas: {}, days: [], skills: [], ...(await json("mine.json").catch(() => ({}))) };
  const page = kata && !kata.elsewhere ? "katas" : name === "quiz" || name === "progress" ? name : "katas";
  for (const each of document.querySelectorAll("nav [data-page]")) each.toggleAttribute("aria-current", each.dataset.page === page);
  document.title = kata ? `${kata.title} · judge` : `judge: ${site.title}`;
  try {
    if (kata && !kata.elsewhere) await showKata(kata);
    else if (page === "quiz") await showQuiz(part);
    else if (page === "progress") showProgress();
    else showKatas();
  } catch {
    main.replaceChildren(el("p", { className: "card" }, "This page could not be fetched. Are you offline? Reload it when you are back."));
  }
  scrollTo(0, 0);
}
/* The service worker comes first, so that it keeps all that follows; a page without one goes on. */
async function held() {
  const workers = navigator.serviceWorker;
  const there = workers && new Promise(resolve => workers.addEventListener("controllerchange", resolve, { once: true }));
  const before = workers?.controller;
  workers?.addEventListener("controllerchange", () => before && location.reload(), { once: true }); // the site is another
  await workers?.register("sw.js");
  if (!workers?.controller) await there;
}
await Promise.race([held().catch(() => {}), new Promise(resolve => setTimeout(resolve, 2000))]);
site = await json("katas.json");
byId = new Map(site.katas.map(kata => [kata.id, kata]));
addEventListener("hashchange", show);
if (typeof WebAssembly !== "object") say("This browser has no WebAssembly, which Python needs here. Use a newer one, or the judge in a terminal.", "failed");
else python.start();
await show();
