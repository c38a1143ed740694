"""Options as fields of structs, and what becomes of a command's value: its view, or a line of JSON."""

from __future__ import annotations

import io
import json
from importlib import import_module
from pathlib import Path

import click
import pytest
from click.testing import CliRunner
from msgspec import Struct
from rich.text import Text

from judge.cli.options import Common, command, emit, opt
from judge.errors import ExitCode
from judge.problem import Verdict
from judge.report.parts import bar, commands, facts, indented, label, table
from judge.report.published_look import Document
from judge.report.screen import Screen, drawn, show
from judge.report.views import view_of
from judge.schema import schema_of


class Ask(Struct, frozen=True):
    groups: tuple[str, ...] = opt("--group G", "Only this one.", default=())
    whole: bool = opt("--all", "Everything.")
    out: Path | None = opt("--out XXX", "Where.")
    count: int = opt("-n --count XXX", "How many.", type=click.IntRange(1, 9), default=3)


class Told(Struct, frozen=True):
    ask: Ask
    problems: tuple[str, ...]
    exit_code: ExitCode = ExitCode.ACCEPTED


@command("show", Told, ask=Ask)
@click.argument("name")
def told(name, ask, common):
    yield Told(ask, (name, *map(str, common.problems)))
    yield Told(ask, (), ExitCode.FAULT)
    yield Told(ask, (), ExitCode.NOT_ACCEPTED)


def invoked(*words: str) -> tuple[ExitCode, list[dict[str, object]]]:
    ended = CliRunner().invoke(told, [*words, "--json"], standalone_mode=False)
    assert ended.exception is None, ended.output
    return ended.return_value, [json.loads(line) for line in ended.output.splitlines()]


def test_a_field_is_an_option_and_the_greatest_exit_code_counts():
    status, (first, *_) = invoked("count")
    assert status is ExitCode.FAULT
    assert first["ask"] == {"groups": [], "whole": False, "out": None, "count": 3}
    words = "count --group a --group b --all --out there -n 5 --problems near --problems far"
    _, (first, *_) = invoked(*words.split())
    assert first["ask"] == {"groups": ["a", "b"], "whole": True, "out": "there", "count": 5}
    assert first["problems"] == ["count", "near", "far"]


def test_what_a_field_does_not_allow_is_refused():
    refused = CliRunner().invoke(told, ["count", "-n", "12"])
    assert refused.exit_code == 2
    assert "1<=x<=9" in refused.output


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "utf-8"])
def test_json_is_whole_on_a_stream_of_few_letters(encoding, monkeypatch):
    stream = io.TextIOWrapper(io.BytesIO(), encoding)
    monkeypatch.setattr("sys.stdout", stream)
    emit(Document("text", ({"n": "→ é \U0001f600"},)), Common(json=True))
    assert json.loads(stream.buffer.getvalue()) == {"n": "→ é \U0001f600"}


def test_a_line_of_json_can_hold_any_number_and_stands_for_what_is_published(capsys):
    assert emit(Document("text", ({"n": 10**400}, {"n": 2})), Common(json=True)) is ExitCode.ACCEPTED
    assert [json.loads(line) for line in capsys.readouterr().out.splitlines()] == [{"n": 10**400}, {"n": 2}]


def test_the_schema_is_made_of_the_type():
    schema = schema_of(told)
    assert schema["$defs"]["Ask"]["properties"]["count"] == {"type": "integer"}
    assert schema["$defs"]["Ask"]["required"] == ["groups", "whole", "out", "count"]


SHOWN = {
    "exercises": "CaseTried HackTurn PageWritten Interviewed Quizzed",
    "klass": "Cohort",
    "look": "Document Home KataList KataShown Mentions Topics Begun HintShown SolutionShown",
    "progress": "ProgressPage QuestionShown Restored RunList RunRow",
    "result": "RunReport Several",
    "setter": "Doctor Exported FilesWritten NewKata Verified VerifySummary",
}


def test_every_value_has_a_view():
    for module, names in SHOWN.items():
        values = import_module(f"judge.report.published_{module}")
        views = import_module(f"judge.report.{module}")
        for name in names.split():
            assert view_of(getattr(values, name, None) or getattr(views, name)) in vars(views).values(), name
    with pytest.raises(AttributeError):
        view_of(Common)


# -- parts ---------------------------------------------------------------------------------------------------

ROWS = [
    ("distance-squared", "12", "The distance squared, so that it stays a whole number."),
    ("foot", "3", ""),
]
HOSTILE = "a\x1b[2J\n::error::b\u202e"


def rows(what: object, width: int | None) -> list[str]:
    return drawn(what, Screen(io.StringIO(), False, width)).splitlines()


@pytest.mark.parametrize("width", [30, 40, 80, 200, None])
def test_a_table_loses_nothing_and_fits(width):
    shown = rows(table(ROWS, "kata", "cases", "about", right=[1]), width)
    assert max(map(len, shown)) <= (width or 100)
    assert all(row == row.rstrip() for row in shown)
    said = " ".join(" ".join(shown).split())
    for row in ROWS:
        assert all(cell in said for cell in row)


def test_a_table_without_prose_is_cut_to_one_row_each():
    assert rows(table([("", "foot", "x" * 50)], prose=None), 20) == ["foot  " + "x" * 13 + "…"]


def test_hostile_text_is_written_out_in_every_part():
    parts = [
        *(facts([(HOSTILE, HOSTILE)]), commands([(HOSTILE, HOSTILE)]), table([(HOSTILE,)], "t")),
        *(bar(1, 2, HOSTILE), indented(Text(HOSTILE.replace("\n", ""))), Text(HOSTILE)),
    ]
    for part in parts:
        stream = io.StringIO()
        show(part, Screen(stream, False, 200))
        said = stream.getvalue()
        assert "\x1b" not in said
        assert "\u202e" not in said
        assert not any(row.strip().startswith("::") for row in said.splitlines())


def test_colours_are_the_terminals_own_sixteen():
    assert drawn(label(Verdict.WA), Screen(io.StringIO(), True, 80)) == "\x1b[1;31mWA\x1b[0m\n"


@pytest.mark.parametrize(("done", "filled"), [(0, 0), (1, 1), (18, 19), (37, 40)])
def test_a_bar_shows_the_first_step_and_the_last(done, filled):
    assert bar(done, 37, "said").plain == f"[{'#' * filled}{'.' * (40 - filled)}]  said"


def test_ascii_terminals_get_escapes():
    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    show(Text("★ é"), Screen(stream, False, 80))
    stream.flush()
    assert stream.buffer.getvalue() == b"\\u2605 \\xe9\n"
