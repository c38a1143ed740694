"""Looking at a page in headless Chromium."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from html import unescape
from pathlib import Path
from typing import Any

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)

# The measure of a page as it is laid out: its width, its smallest words, and how every word stands out.
_MEASURE = """
for (const folded of document.querySelectorAll("details")) folded.open = true;
const parts = text => { const found = text.match(/[\\d.]+/g).map(Number); return [...found, 1].slice(0, 4); };
const over = (top, below) => [0, 1, 2].map(i => top[i] * top[3] + below[i] * (1 - top[3])).concat(1);
function ground(element) {
  const drawing = element.closest("figure svg");
  if (drawing) return parts(getComputedStyle(drawing.querySelector("rect.panel")).fill);
  const layers = [];
  for (let each = element; each; each = each.parentElement) {
    layers.push(parts(getComputedStyle(each).backgroundColor));
  }
  return layers.reverse().reduce((below, top) => over(top, below), [255, 255, 255, 1]);
}
function luminance(colour) {
  const linear = v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
  const [r, g, b] = colour.map(v => linear(v / 255));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
const faint = [];
let words = 0, least = 99;
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const element = walker.currentNode.parentElement, word = walker.currentNode.data.trim();
  if (!word || element.closest("script,title,desc") || !element.getClientRects().length) continue;
  const looks = getComputedStyle(element), below = ground(element);
  const ink = over(parts(element.closest("svg") ? looks.fill : looks.color), below);
  const [dark, light] = [luminance(ink), luminance(below)].sort((a, b) => a - b);
  const ratio = (light + 0.05) / (dark + 0.05);
  const svg = element.closest("figure svg");
  const drawn = svg ? svg.viewBox.baseVal.width : 0;  // a chart keeps its letters' size
  const scale = drawn ? svg.getBoundingClientRect().width / drawn : 1;
  words += 1;
  least = Math.min(least, parseFloat(looks.fontSize) * scale);
  if (ratio < 4.5) faint.push([word.slice(0, 40), ratio]);
}
parent.postMessage(JSON.stringify({
  words, faint, least, width: innerWidth, needed: document.documentElement.scrollWidth,
  dark: matchMedia("(prefers-color-scheme: dark)").matches,
  paper: getComputedStyle(document.documentElement).backgroundColor,
}), "*");
"""
# Chromium's window has a least width of its own, a frame has none; and a dump tells of the outer page only.
_FRAME = """<!doctype html><meta charset="utf-8"><meta name="color-scheme" content="light dark">
<pre id="measured"></pre>
<script>onmessage = said => { document.getElementById("measured").textContent = said.data; };</script>
<iframe src="WHERE" style="width:WIDTHpx;height:900px;border:0"></iframe></html>
"""


def dom(page: Path, *, dark: bool = False) -> str:
    """The page as Chromium holds it after everything that could run has run."""
    assert CHROMIUM is not None
    command = [
        CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
        "--hide-scrollbars", "--window-size=1500,1000", f"--user-data-dir={page.parent / 'chromium'}",
        *(["--blink-settings=preferredColorScheme=0"] if dark else []),
        "--virtual-time-budget=2000", "--dump-dom", page.absolute().as_uri(),
    ]  # fmt: skip
    ended = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=120, check=True)
    assert "</html>" in ended.stdout, ended.stderr
    return ended.stdout


def without_policy(page: Path, script: str) -> Path:
    """A copy that a script may run in, and does."""
    html, found = re.subn(r"<meta http-equiv=[^>]*>", "", page.read_text(encoding="utf-8"))
    assert found == 1
    copy = page.with_name(f"{page.stem}-open.html")
    copy.write_text(html.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
    return copy


def measured(page: Path, *, width: int, dark: bool) -> dict[str, Any]:
    """The measure of the page at that width."""
    frame = page.with_name("frame.html")
    inner = without_policy(page, _MEASURE).name
    frame.write_text(_FRAME.replace("WHERE", inner).replace("WIDTH", str(width)), encoding="utf-8")
    (found,) = re.findall(r'<pre id="measured">(.*?)</pre>', dom(frame, dark=dark), re.DOTALL)
    told: dict[str, Any] = json.loads(unescape(found))
    return told
