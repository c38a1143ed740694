"""Judging a submission from beginning to end, as a value: a job in, a result out, nothing printed.

api.py          `judge(problem, source)` and `run(job)`, for other people's programs
options.py      how to judge; a job
session.py      judging many submissions to one problem, with all that they share
containment.py  what is hidden from them; the level of isolation that this machine is known to have
pool.py         who does the work: here, or processes of this machine
cases.py        one case; breaking a wrong program; fresh cases
inprocess.py    a routine of this very process
"""
