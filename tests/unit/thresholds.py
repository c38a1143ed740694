"""Functions of this very process in the place of a contained submission: what thresholds are measured of."""

from __future__ import annotations

import json
from functools import cache

from judge.data.borders import borders_of
from judge.data.module import load_module
from judge.mistakes.thresholds import measured
from judge.problem.find import find_problem
from judge.run.function import FunctionRunner
from judge.sandbox.boundary import CallsResult, Reply, Stop, Usage


class Here:
    """A box that calls a function; it counts its series and their calls."""

    def __init__(self, function, stops=()):
        self.function = function
        self.stops = list(stops)  # how series end that do not come to their end
        self.series = []

    def call_many(self, entry, calls, limits):
        self.series.append(len(calls))
        if self.stops:
            return CallsResult((Reply(self.stops.pop(0)),), Usage())
        return CallsResult(tuple(self._reply(call) for call in calls), Usage())

    def _reply(self, call):
        try:
            return Reply(Stop.ANSWERED, json.loads(json.dumps(self.function(*call))))
        except Exception as fault:
            return Reply(Stop.EXCEPTION, detail=str(fault))


@cache
def borders(name):
    problem = find_problem(name)
    return borders_of(problem, load_module(problem))


def thresholds(name, function, *, first_only=False, box=None):
    """The thresholds of a function that answers problem `name`, by decision."""
    runner = FunctionRunner(find_problem(name))
    found = measured(borders(name), runner, box or Here(function), first_only=first_only)
    return {each.decision: each for each in found}
