#!/bin/sh
# From one side of the negative x axis to the other it is 359.9 degrees in pygame, -0.1 in pymunk.
#
# Asked:    the angle from the direction (-1, -0.001) to (-1, 0.001), by pygame-ce and by pymunk, which are
#           used together.
# Guess:    -0.115 degrees from both: the signed angle of the shorter turn.
# Seen:     pygame-ce 2.5.8: Vector2.angle_to gives 359.885, the difference of two arctangents, anywhere
#           between -360 and 360. pymunk 7.3.1: Vec2d.get_angle_between gives -0.002 radians, which is -0.115
#           degrees. Away from that axis they agree.
# So:       a test of a field of view, `abs(a.angle_to(b)) < 30`, fails for whoever looks to the left, and is
#           right in the other directions, so that tests pass. Use atan2 of the cross and the dot product.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q pygame-ce==2.5.8 pymunk==7.3.1 cffi==2.0.0 || exit 2
cat > angle.py <<'PY'
from math import degrees

from pygame import Vector2
from pymunk import Vec2d

for a, b in (((-1, -0.001), (-1, 0.001)), ((1, -0.001), (1, 0.001))):
    print(f"{Vector2(a).angle_to(b):.3f} {degrees(Vec2d(*a).get_angle_between(b)):.3f}")
PY
seen=$(PYGAME_HIDE_SUPPORT_PROMPT=1 venv/bin/python angle.py)
before='359.885 -0.115
0.115 0.115'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'pygame-angle-to: as before, 359.885 degrees in pygame-ce 2.5.8, -0.115 in pymunk 7.3.1'
