"""README's first run: its program, judged. Run as a script, it writes what the judge says into README.md."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
_COLUMNS = "88"


def first_run(readme: str) -> tuple[int, str]:
    """The status and the output of judging the page's Python program."""
    (program,) = re.findall(r"^```python\n(.*?)^```$", readme, re.MULTILINE | re.DOTALL)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "mine.py").write_text(program, encoding="utf-8")
        settings = {
            "PYTHONPATH": str(ROOT),
            "JUDGE_CACHE": f"{folder}/cache",
            "JUDGE_DB": f"{folder}/history.sqlite3",
            "COLUMNS": _COLUMNS,
        }
        ended = subprocess.run(
            [sys.executable, "-m", "judge", "run", "count", "mine.py"],
            cwd=folder,
            env={**os.environ, **settings},
            stdout=subprocess.PIPE,
            encoding="utf-8",
            timeout=120,
        )
    return ended.returncode, ended.stdout


def masked(text: str) -> str:
    """The output without the figures that differ from run to run, and without the smallest case's numbers:
    how far the search comes in its time is the machine's affair.
    """
    text = re.sub(
        r"(?<=smallest case found\n)(    input) .*?(?=\n    wanted)", r"\1 …", text, flags=re.DOTALL
    )
    text = re.sub(r"judge replay \S+", "judge replay …", text)
    return re.sub(r"[\d.,]+ ms CPU, \d+ MB", "…", text)


def main() -> None:
    """Bring README.md up to date."""
    path = ROOT / "README.md"
    readme = path.read_text(encoding="utf-8")
    head, rest = readme.split("```text\n", 1)
    path.write_text(f"{head}```text\n{first_run(readme)[1]}```{rest.split('```', 1)[1]}", encoding="utf-8")


if __name__ == "__main__":
    main()
