/* Python and the judge, in a worker. app.js puts `const BASE = …` before this text and starts it from a blob: only so
   does it have the page's content security policy, without which a program could reach other sites. */

const bytes = async path => {
  const found = await fetch(BASE + path);
  if (!found.ok) throw new Error(`${path}: ${found.status}`);
  return new Uint8Array(await found.arrayBuffer());
};

/* The interpreter's memory just after its start is kept: from it, it starts eight times as fast. Where that cannot
   be, it starts as usual. */
async function started(loadPyodide, version) {
  const place = `${BASE}memory-${version}`, store = await self.caches?.open("judge-memory").catch(() => null); // none by plain http
  const kept = store && (await store.match(place).catch(() => null));
  const options = { indexURL: `${BASE}pyodide/` };
  if (kept) {
    try {
      return await loadPyodide({ ...options, _loadSnapshot: new Uint8Array(await kept.arrayBuffer()) });
    } catch {
      await store.delete(place);
    }
  }
  try {
    if (!store) return await loadPyodide(options);
    const python = await loadPyodide({ ...options, _makeSnapshot: true });
    for (const old of await store.keys()) await store.delete(old);
    await store.put(place, new Response(python.makeMemorySnapshot())).catch(() => {});
    return python;
  } catch {
    return loadPyodide(options);
  }
}

const [{ loadPyodide, version }, judge, msgspec] = await Promise.all([
  import(`${BASE}pyodide/pyodide.mjs`), bytes("judge.zip"), bytes("wheels/msgspec.whl")]);
const python = await started(loadPyodide, version);
const packages = python.runPython("import site; site.getsitepackages()[0]");
python.unpackArchive(msgspec, "zip", { extractDir: packages });
python.unpackArchive(judge, "zip", { extractDir: packages });

const post = self.postMessage.bind(self);
let run = null;
python.registerJsModule("page", {
  alive: () => post({ run, alive: true }),
  memory: () => python._module.HEAPU8.length,
  progress: (done, cases) => post({ run, progress: [done, cases] }),
  told: text => post({ run, told: JSON.parse(text), last: false }),
});
const tab = python.runPython(`
import os, page
os.environ["JUDGE_CACHE"] = "/cache"
from judge.site.tab import Tab
Tab(page)`);

/* From here on a program could run. What it could reach the page's stores and other places by is taken away; katas
   and packages come in messages. */
const GONE = ["caches", "indexedDB", "fetch", "XMLHttpRequest", "WebSocket", "WebSocketStream", "EventSource", "WebTransport",
  "RTCPeerConnection", "importScripts", "Worker", "SharedWorker", "BroadcastChannel", "navigator", "postMessage", "close",
  "addEventListener", "dispatchEvent", "cookieStore", "Notification", "FileReaderSync", "onmessage"];
let messages = null;
self.onmessage = event => messages(event.data);
for (let at = self; at; at = Object.getPrototypeOf(at)) {
  for (const name of GONE) {
    if (!Object.hasOwn(at, name) || name === "onmessage") continue;
    try {
      Object.defineProperty(at, name, { value: undefined, configurable: false });
    } catch {
      delete at[name];
    }
  }
}

messages = asked => {
  try {
    for (const wheel of asked.wheels || []) python.unpackArchive(wheel, "zip", { extractDir: packages });
    if (asked.archive) {
      python.unpackArchive(asked.archive, "zip", { extractDir: `/katas/${asked.kata}` });
      tab.open(asked.kata);
      post({ opened: asked.kata });
    }
    if (asked.run) {
      run = asked.run;
      post({ run, told: JSON.parse(tab.judge(asked.kata, asked.source)), last: true });
    }
  } catch (fault) {
    const lines = String(fault).trim().split("\n");
    post({ run: asked.run, fault: lines.findLast(line => /^[\w.]+(Error|Exception|Exit|Interrupt|:)/.test(line)) || lines.at(-1) });
  }
};
post({ ready: python.runPython("import sys; sys.version.split()[0]") });
