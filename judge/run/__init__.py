"""Judging one submission: running it on cases, comparing, measuring.

runner.py     one interface for all ways to run it, and what comes back; program.py, formatted.py
group.py      a test group while it is judged; groups.py judges several in as few processes as it takes
execute.py    all groups, and what they come to; settings.py: how, and the reference solutions
timing.py     the race against the reference, and what its turns say
growing.py    groups that are timed by how they grow; growth.py: what their turns say
foreign.py    the race in other languages, and the passes that it is made of
result.py     what all of it came to; kept.py: reading it again
tried.py      a person's own case, and what was said of it
stress.py     fresh cases without end
alone.py      measuring alone on the whole machine
"""
