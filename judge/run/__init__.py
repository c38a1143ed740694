"""Judging one submission: running it on cases, comparing, measuring.

runner.py        one interface for all ways to run it, and what comes back; program.py, formatted.py
group.py         a test group while it is judged; groups.py runs several in as few processes as it takes
execute.py       all groups, and what they come to; settings.py: how; budget.py: at what cost at most
reference.py, measure.py, timing.py
                 the race against the reference solution, and what its turns say
result.py        what all of it came to; tried.py: a person's own case, and what was said of it
stress.py        fresh cases without end
alone.py         measuring alone on the whole machine
"""
