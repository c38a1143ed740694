"""README and the other pages say what is so."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from first_run import first_run, masked

from judge.errors import ExitCode
from judge.spec import Verdict
from judge.spec.find import all_problems

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["judge", "tests"])
def test_the_two_commands_are_one_line_each_and_set_themselves_up(name):
    ((command,),) = [re.findall(rf"<!-- {name} -->\n```sh\n(.*)\n```", README)]
    assert command.startswith("python3 -m venv .venv && .venv/bin/pip install ")
    if name == "judge":
        for problem in all_problems():
            if problem.folder.parent == ROOT / "problems":
                assert problem.id in command
    else:
        assert "[test]" in command
        assert command.endswith(".venv/bin/pytest")


def test_the_problems_table(monkeypatch):
    monkeypatch.delenv("JUDGE_PROBLEMS", raising=False)
    for problem in all_problems():
        signature = f"{problem.entry}({', '.join(parameter.name for parameter in problem.parameters)})"
        assert f"| `{problem.id}` | {problem.tier.value} | `{signature}` |" in README


def test_exit_codes_and_verdicts():
    for code in ExitCode:
        assert re.search(rf"^\| {code.value} \|", README, re.MULTILINE)
    for verdict in Verdict:
        assert f"`{verdict.value}`" in README


def test_the_first_run_looks_as_shown():
    status, written = first_run(README)
    assert status == 1
    (shown,) = re.findall(r"^```text\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
    assert masked(written) == masked(shown), "python tests/packaging/first_run.py writes it into README.md"


@pytest.mark.parametrize(
    "page", ["README.md", ".github/CONTRIBUTING.md", ".github/CHANGELOG.md", "tests/README.md"]
)
def test_links_lead_somewhere(page):
    path = ROOT / page
    if not path.exists():
        pytest.skip("not part of a source distribution")
    for target in re.findall(r"\]\(([^)#]+)\)", path.read_text(encoding="utf-8")):
        if not target.startswith("http"):
            assert (path.parent / target).exists(), target
