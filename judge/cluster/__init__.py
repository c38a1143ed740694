"""Other machines that judge: the executor that sends submissions to them, and what is started there.

    where.py      what `--on` names; on.py: the executor there
    ring.py       the executor: a window of submissions, lost workers, lost schedulers
    parcel.py     what travels
    greeting.py   whether a worker judges as this machine does
    serve.py      the processes of `judge worker`; quiet.py: without web servers
    reach.py      whether anybody listens there
    keys.py       certificates: who may reach a cluster
    launch.py     workers that `--on` starts itself; ssh.py and slurm.py: with what
    station.py    what this machine has to offer, and what it prepares
    need.py       the one place that imports dask.distributed

Only text, bytes and integers travel, and a function by its name. Nothing here is imported before `--on` or
`judge worker` is used.
"""
