"""Problem packages that other judges read: Kattis and ICPC, both ways.

export/     a problem of ours as a package
foreign/    packages of others, read and judged here
"""
