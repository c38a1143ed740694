"""list, show, data and verify: what a person and what a script sees."""

from __future__ import annotations

import json
import shutil


def test_list(judge):
    ended = judge("list")
    assert (ended.status, ended.err) == (0, "")
    rows = {line.split()[0]: line for line in ended.lines[1:]}
    assert rows["middle"].split() == ["middle", "junior", "52", "The", "middle"]
    assert {"count", "segment", "ray-nearest", "exact-count"} <= set(rows)
    tiers = [line.split()[1] for line in ended.lines[1:]]
    order = ["junior", "middle", "senior", "professional"]
    assert tiers == sorted(tiers, key=order.index)


def test_list_json(judge):
    objects = [json.loads(line) for line in judge("list", "--json").lines]
    (middle,) = [each for each in objects if each["problem"] == "middle"]
    assert middle == {
        "schema": 1,
        "problem": "middle",
        "title": "The middle",
        "tier": "junior",
        "summary": "The number half-way between two others.",
        "entry": "middle",
        "groups": 3,
        "cases": 52,
        "points": 100,
    }


def test_show(judge):
    ended = judge("show", "middle")
    assert (ended.status, ended.err) == (0, "")
    assert ended.out.startswith("# The middle\n\n`middle(a, b)` returns the number **half-way** between")
    rows = [line.split() for line in ended.lines]
    assert ["a", "number", "-1000", "1000", "one", "number"] in rows
    assert ["half", "30", "50"] in [row[:3] for row in rows]
    assert "  1e-9 relative; where the exact number is 0, 1e-12 of the answer's unit" in ended.lines
    assert ["memory", "256", "MB"] in rows


def test_show_names_the_tolerance_of_a_group_that_has_its_own(judge, pack, tmp_path):
    shutil.copytree(pack, tmp_path / "pack")
    file = tmp_path / "pack" / "problems" / "middle" / "problem.toml"
    file.write_text(file.read_text() + "tolerance = { ulps = 4, relative = 1e-9 }\n")
    ended = judge("show", "middle", "--problems", tmp_path / "pack" / "problems")
    assert "ends in a half. Tolerance: 1e-9 relative + 4 ulp." in ended.out
    assert "  none: the exact answer" in judge("show", "exact-count").lines


def test_show_json(judge):
    ended = judge("show", "middle", "--json")
    shown = json.loads(ended.out)
    assert ended.out.count("\n") == 1
    assert shown["problem"] == "middle"
    assert shown["parameters"][0] == {
        "name": "a",
        "type": "number",
        "low": "-1000",
        "high": "1000",
        "smallest": "0",
        "about": "one number",
    }
    assert shown["groups"][2]["kills"] == ["floor-division"]
    assert shown["groups"][0]["tolerance"]["relative"] == "1/1000000000"
    assert shown["examples"][0] == {"input": {"a": 1, "b": 2}, "answer": 1.5}
    assert shown["statement"].startswith("# The middle\n")


def test_data_writes_what_a_program_reads_and_what_is_accepted(judge, tmp_path):
    ended = judge("data", "middle", "--out", tmp_path / "new" / "folder")
    assert (ended.status, ended.err) == (0, "")
    assert ended.out.endswith("52 cases in 9 files\n")
    folder = tmp_path / "new" / "folder"
    read = (folder / "half.in").read_text().splitlines()
    wanted = (folder / "half.ans").read_text().splitlines()
    document = json.loads((folder / "half.json").read_text())
    assert read[0] == "30"
    assert len(read) == len(wanted) + 1 == len(document["cases"]) + 1 == 31
    assert (document["schema"], document["problem"], document["group"]) == (1, "middle", "half")
    for line, answer, case in zip(read[1:], wanted, document["cases"], strict=True):
        a, b = map(int, line.split())
        assert case["input"] == {"a": a, "b": b}
        assert float(answer) == float(case["expected"]) == (a + b) / 2
        low, high = case["accepted"]
        assert low < (a + b) / 2 < high


def test_a_program_that_prints_the_answers_of_data_is_accepted(judge, submit, tmp_path):
    judge("data", "segment", "--out", tmp_path / "out", "--group", "examples")
    answers = (tmp_path / "out" / "examples.ans").read_text()
    name = submit(f"print({answers!r}, end='')\n")
    assert judge("run", "segment", name, "--group", "examples").status == 0


def test_data_of_one_group_and_another_seed_as_json(judge, tmp_path):
    first = judge("data", "middle", "--out", tmp_path / "a", "--group", "whole", "--json")
    assert json.loads(first.out) == {
        "schema": 1,
        "problem": "middle",
        "out": str(tmp_path / "a"),
        "cases": 20,
        "files": ["whole.in", "whole.ans", "whole.json"],
    }
    judge("data", "middle", "--out", tmp_path / "b", "--group", "whole", "--seed", 5)
    texts = [(tmp_path / folder / "whole.in").read_text() for folder in "ab"]
    assert texts[0] != texts[1]


def test_data_writes_over_nothing_unasked(judge, tmp_path):
    judge("data", "middle", "--out", tmp_path)
    (tmp_path / "half.in").write_text("mine")
    ended = judge("data", "middle", "--out", tmp_path)
    assert ended.status == 2
    assert "examples.in and 8 more files would be written over" in ended.err
    assert (tmp_path / "half.in").read_text() == "mine"
    assert judge("data", "middle", "--out", tmp_path, "--force").status == 0
    assert (tmp_path / "half.in").read_text() != "mine"


def test_verify_a_sound_problem(judge):
    ended = judge("verify", "middle")
    assert (ended.status, ended.err) == (0, "")
    assert ended.lines[0] == "middle  3 groups, 52 cases, pins matching"
    assert ended.lines[5].replace("examples, ", "").split() == ["wrong/floor-division.py", "WA", "half"]
    assert ended.lines[-1] == "sound  1 problem checked"


def test_verify_with_the_kill_matrix(judge):
    ended = judge("verify", "middle", "--matrix")
    assert ended.status == 0
    assert ended.lines[3].split("  ")[1:2] == ["floor-division"]
    assert "half, examples" in ended.lines[3]
    assert "least set" in ended.out
    plain = json.loads(judge("verify", "middle", "--matrix", "--json").out)["matrix"]
    (program,) = plain["programs"]
    assert (program["file"], program["own"], program["aimed"]) == (
        "wrong/floor-division.py",
        "half",
        ["half"],
    )
    assert plain["groups"] == list(program["rejected"]) == list(program["cases"])
    assert program["rejected"]["whole"] == []
    (case,) = plain["cover"]
    assert case["case"] in program["rejected"][case["group"]]
    assert plain["unkilled"] == []
    assert "matrix" not in json.loads(judge("verify", "middle", "--json").out)


def test_verify_json_and_pins(judge, pack, tmp_path):
    shutil.copytree(pack, tmp_path / "pack")
    folder = tmp_path / "pack" / "problems"
    (folder / "middle" / "hashes.json").unlink()
    unpinned = judge("verify", "middle", "--json", "--problems", folder)
    assert unpinned.status == 3
    report = json.loads(unpinned.out)
    assert (report["schema"], report["problem"], report["ok"]) == (1, "middle", False)
    assert (report["groups"], report["cases"], report["pins"]) == (3, 52, "differing")
    assert report["solutions"][2] == {
        "file": "wrong/floor-division.py",
        "name": "floor-division",
        "verdict": "WA",
        "ok": True,
        "failed": ["examples", "half"],
    }
    assert [set(fault) for fault in report["faults"]] == [{"what", "where", "remedy"}]
    assert judge("verify", "middle", "--pin", "--problems", folder).status == 0
    pinned = judge("verify", "--json", "--problems", folder)  # of that folder alone, which is one problem
    assert pinned.out.count("\n") == 1
    assert (pinned.status, json.loads(pinned.out)["pins"]) == (0, "matching")


def test_verify_names_what_is_wrong(judge, pack, tmp_path):
    shutil.copytree(pack, tmp_path / "pack")
    wrong = tmp_path / "pack" / "solutions" / "middle" / "accepted" / "other.py"
    wrong.write_text('"""other"""\n\n\ndef middle(a, b):\n    return a\n')
    ended = judge("verify", "middle", "--problems", tmp_path / "pack" / "problems")
    assert ended.status == 3
    assert "fault  middle/accepted/other.py: gets WA where AC is wanted" in ended.out
    assert ended.lines[-1] == "1 fault  1 problem checked"
