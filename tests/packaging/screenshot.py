"""README's film: real commands in a terminal, drawn as SVG. Run as a script, it draws it anew.

It shows a run that fails, a hint, and the run that is accepted; the first alone where motion is unwanted.
"""

from __future__ import annotations

import html
import io
import re
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from pathlib import Path

from pseudoterminal import COLUMNS, run
from walk import ROOT

FILM = ROOT / ".github" / "loop.svg"
_COMMAND = "judge run segment.py"
_CLAMP = "        if -near <= to_foot + step <= length + near\n"  # what the wrong try has forgotten
_SECONDS = (8, 5, 5)  # that the scenes of the film last
_TITLE = "judge"
# Colours that hold on the picture's own dark ground, whatever the page around it; SGR 2 is dimmed by hand.
_GROUND, _TEXT, _FAINT = (13, 17, 23), (201, 209, 217), "139;148;158"
_SIXTEEN = [
    (72, 79, 88), (255, 123, 114), (86, 211, 100), (227, 179, 65),
    (121, 192, 255), (210, 168, 255), (86, 212, 221), (240, 246, 252),
]  # fmt: skip
_FONTS = "ui-monospace, 'DejaVu Sans Mono', 'Cascadia Mono', Menlo, Consolas, monospace"
_WIDTH = 12.2  # of a character, in the picture's units
_PIECE = re.compile(
    r'<text class="(?P<style>[\w-]+)" x="(?P<x>[\d.]+)" y="(?P<y>[\d.]+)" textLength="[\d.]+" '
    r'clip-path="(?P<clip>[^"]+)">(?P<text>[^<]*)</text>'
)


def real_loop(cache: Path | None = None, scenes: int = 3) -> list[str]:
    """What a terminal shows of a wrong try, of a hint and of a right one; only the first scenes."""
    right = (ROOT / "solutions" / "segment" / "accepted" / "tolerant.py").read_text("utf-8")
    wrong = right.replace(_CLAMP, "")
    assert wrong != right
    files = (wrong, None, right)
    shown = []
    with tempfile.TemporaryDirectory() as folder:
        settings = {"JUDGE_CACHE": str(cache or f"{folder}/cache"), "JUDGE_DB": f"{folder}/history.sqlite3"}
        settings["PYTHONPATH"] = str(ROOT)
        for words, source in zip((_COMMAND, "judge hint", _COMMAND), files[:scenes], strict=False):
            if source is not None:
                (Path(folder) / "segment.py").write_text(source, encoding="utf-8")
            _, said, _ = run([sys.executable, "-m", *words.split()], Path(folder), settings)
            shown.append(f"\x1b[1m$\x1b[0m {words}\n\n{said}")
    return shown


def film(shown: Sequence[str]) -> str:
    """One SVG that shows these screens in turn, for ever; the first alone where motion is unwanted."""
    whole, begins, parts, rules = sum(_SECONDS), 0, [], []
    sizes, rows = [], max(screen.count("\n") for screen in shown)
    for number, (screen, lasts) in enumerate(zip(shown, _SECONDS, strict=True)):
        svg = drawn(screen + "\n" * (rows - screen.count("\n")), f"scene{number}")
        width, height = map(float, re.findall(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg)[0])
        sizes.append((width, height))
        scene = svg.replace("<svg ", f'<svg width="{width:g}" height="{height:g}" ', 1)
        parts.append(f'<g class="scene" id="g{number}">\n{scene}</g>\n')
        start, end = 100 * begins / whole, 100 * (begins + lasts) / whole
        rules.append(
            f"@keyframes k{number}{{0%,{start:.2f}%{{opacity:{int(not begins)}}}"
            f"{start + 0.01:.2f}%,{end - 0.01:.2f}%{{opacity:1}}{end:.2f}%,100%{{opacity:0}}}}\n"
            f"#g{number}{{animation:k{number} {whole}s step-end infinite}}\n"
        )
        begins += lasts
    width, height = (max(each) for each in zip(*sizes, strict=True))
    still = "@media (prefers-reduced-motion:reduce){.scene{animation:none!important}#g0{opacity:1}}\n"
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}">\n'
    return f"{head}<style>.scene{{opacity:0}}\n{''.join(rules)}{still}</style>\n{''.join(parts)}</svg>\n"


def drawn(shown: str, name: str = "judge") -> str:
    """The SVG of what was shown: no script, no address but SVG's own, fonts of the machine it is seen on."""
    from rich.console import Console
    from rich.terminal_theme import TerminalTheme
    from rich.text import Text

    console = Console(record=True, width=COLUMNS, file=io.StringIO(), color_system="truecolor")
    bare = re.sub(r"\x1b\]8;;[^\x1b]*\x1b\\", "", shown)
    console.print(Text.from_ansi(bare.replace("\x1b[2m", f"\x1b[38;2;{_FAINT}m")))
    theme = TerminalTheme(_GROUND, _TEXT, _SIXTEEN, _SIXTEEN)
    svg = console.export_svg(title=_TITLE, theme=theme, unique_id=name)
    svg = re.sub(r"<!--.*?-->\s*", "", svg, flags=re.DOTALL)
    svg = re.sub(r"@font-face \{.*?\}\s*", "", svg, flags=re.DOTALL)
    svg = _PIECE.sub(_placed, svg.replace("Fira Code, monospace", _FONTS))
    return re.sub(r"[ \t]+$|\n(?=\n)", "", svg, flags=re.MULTILINE)


def _placed(piece: re.Match[str]) -> str:
    """Every group of words at its own place: not everything that draws SVG keeps spaces."""
    placed = []
    for words in re.finditer(r"\S+(?: \S+)*", html.unescape(piece["text"]).replace("\xa0", " ")):
        x = float(piece["x"]) + _WIDTH * words.start()
        length = _WIDTH * len(words[0])
        placed.append(
            f'<text class="{piece["style"]}" x="{x:g}" y="{piece["y"]}" textLength="{length:g}" '
            f'clip-path="{piece["clip"]}">{html.escape(words[0], quote=False)}</text>\n'
        )
    return "".join(placed)


def text_of(svg: str) -> str:
    """The lines of text in a picture, top to bottom, without its title."""
    rows: dict[float, list[tuple[float, str]]] = {}
    for element in ElementTree.fromstring(svg).iter("{http://www.w3.org/2000/svg}text"):
        if "clip-path" in element.attrib:
            piece = (float(element.attrib["x"]), element.text or "")
            rows.setdefault(float(element.attrib["y"]), []).append(piece)
    return "".join(f"{_row(rows[y])}\n" for y in sorted(rows))


def _row(pieces: list[tuple[float, str]]) -> str:
    """The pieces of a row, each at its column."""
    text = ""
    for x, piece in sorted(pieces):
        text = text.ljust(round(x / _WIDTH)) + piece
    return text.rstrip()


def main() -> None:
    """Draw the film anew."""
    FILM.write_text(film(real_loop()), encoding="utf-8")


if __name__ == "__main__":
    main()
