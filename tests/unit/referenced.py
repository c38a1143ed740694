"""The problem `middle` with a reference solution in each of several languages, in a folder for a test."""

from __future__ import annotations

import shutil
from pathlib import Path

from judge.problem.load import load_problem

PACK = Path(__file__).parents[1] / "fixtures" / "pack"
SOURCES = {
    "c": "bool middle(double a, double b, double *out) { *out = (a + b) / 2; return true; }",
    "cpp": "double middle(double a, double b) { return (a + b) / 2; }",
    "go": "package main\n\nfunc middle(a, b float64) (float64, bool) { return (a + b) / 2, true }",
    "java": "class Solution { static double middle(double a, double b) { return (a + b) / 2; } }",
    "js": "function middle(a, b) { return (a + b) / 2; }",
    "rs": "fn middle(a: f64, b: f64) -> f64 { (a + b) / 2.0 }",
}
IDS = {"js": "javascript", "rs": "rust"}
HEAD = "// Mean.\n//\n// Half of the sum. It does not overflow here.\n"


def referenced(folder, *suffixes, limit=50, **more):
    """The problem; `more` are entries of `[time.references]` beside those of these suffixes."""
    shutil.copytree(PACK, folder, dirs_exist_ok=True)
    toml = folder / "problems" / "middle" / "problem.toml"
    names = {IDS.get(each, each): f"reference.{each}" for each in suffixes} | more
    rule = [f'[time]\nlimit = {limit}\nfunction = "mean.py"\nprogram = "program.py"\n']
    if names:
        rule += ["[time.references]", *(f'{key} = "{name}"' for key, name in names.items()), ""]
    toml.write_text(toml.read_text().replace("[tolerance]", "\n".join([*rule, "[tolerance]"]), 1))
    for each in suffixes:
        path = folder / "solutions" / "middle" / "accepted" / f"reference.{each}"
        path.write_text(f"{HEAD}{SOURCES[each]}\n")
    return load_problem(folder / "problems" / "middle")
