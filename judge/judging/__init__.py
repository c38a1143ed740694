"""Judging a submission from beginning to end, as a value: a job in, a result out, nothing printed.

public.py       `judge(problem, source)` and `run(job)`, for other people's programs
job.py          what is to be judged, and how
session.py      judging many submissions to one problem, with all that they share
executors.py    who does the work: here
processes.py    … or processes of this machine
containment.py, isolation.py
                the boxes; the level of isolation that this machine is known to have
diagnosis.py, naming.py
                the smallest case that breaks a submission; the mistake's name
stressing.py, trying.py, hacking.py, routine.py
                fresh cases; one case; breaking a wrong program; a routine of this very process
"""
