"""The table of edges: what of a signature and of the decisions has cases, and what has none."""

from __future__ import annotations

from judge.data.load import load_data
from judge.problem.declare import decided, decisions
from judge.problem.find import find_problem
from judge.verify.edges import edges_of


def test_count_has_cases_at_every_edge():
    edges = {each.what: each.cases for each in edges_of(load_data(find_problem("count")))}
    assert {"A = B", "r is 0", "A is 0", "cx = cy", "all ints", "all below 1e-6"} <= set(edges)
    assert "cx = A" not in edges
    assert {"The line is a tangent: exactly", "The line is a tangent: nearly"} <= set(edges)
    assert min(edges.values()) > 0


def test_an_edge_that_no_case_may_have_is_told_too():
    edges = {each.what: each.cases for each in edges_of(load_data(find_problem("which-side")))}
    assert edges["A = B"] == 0
    assert edges["A = P"] > 0
    assert "all ints" not in edges  # there is nothing else


def test_decisions_are_told_to_those_who_ask():
    decided("nobody listens", 0.5)
    with decisions() as outer:
        decided("first", 0.0)
        with decisions() as inner:
            decided("second", 1e-7)
        decided("third", -0.25)
    assert [each.what for each in outer] == ["first", "third"]
    assert inner == [("second", 1e-7)]
