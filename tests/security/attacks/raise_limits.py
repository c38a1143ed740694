"""Raise the limits of this process."""

import json
import resource
import sys

target = json.load(sys.stdin)

try:
    resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    print("BREACH")
except (OSError, ValueError) as error:
    print("held", error)
