"""README's picture of the site: a wrong program, judged in a real browser. As a script, it takes it anew."""

from __future__ import annotations

import base64
import sys
import tempfile
from pathlib import Path

from walk import ROOT

sys.path.insert(0, str(ROOT / "tests" / "cli"))

from devtools import chromium
from test_site_browser import READY, judged, served

from judge.problem.find import find_problem
from judge.site.build import build
from judge.site.fetch import parts

PICTURE = ROOT / ".github" / "site.png"
_WRONG = """from math import hypot

def line_count(cx, cy, r, A, B):
    if A == B:
        return None
    dx, dy = B[0] - A[0], B[1] - A[1]
    k = dx * (A[1] - cy) - dy * (A[0] - cx)
    d = abs(k) / hypot(dx, dy)
    return 2 if d < r else 1 if d == r else 0
"""


def main() -> None:
    """Build the site of one kata, judge, and keep what the page looks like."""
    with tempfile.TemporaryDirectory(prefix="judge-tests-") as folder:
        site = Path(folder, "site")
        build(site, [find_problem("count")], [], parts(None))
        with served(site) as (_, address), chromium(Path(folder, "profile")) as tab:
            size = {"width": 1280, "height": 860, "deviceScaleFactor": 1, "mobile": False}
            tab.call("Emulation.setDeviceMetricsOverride", **size)
            tab.go(f"{address}/#count")
            tab.until(READY)
            said = judged(tab, _WRONG)
            assert "Wrong answer" in said, said
            tab.until("document.querySelector('.case img')?.naturalWidth > 0")
            PICTURE.write_bytes(base64.b64decode(tab.call("Page.captureScreenshot")["data"]))


if __name__ == "__main__":
    main()
