#!/bin/sh
# sympy mirrors a circle into one of negative radius, which holds no point.
#
# Asked:    what is the circle of centre (0, 0) and radius 1 after a reflection in the line x = 5?
# Guess:    Circle((10, 0), 1), equal to one that is made so.
# Seen:     sympy 1.14.0: its radius is -1. It is not equal to that circle, its area is -pi, and it does not
#           enclose its own centre; its intersection with a line is right.
# So:       whoever mirrors a figure with sympy compares, sorts or tests circles by `abs(circle.radius)`, or
#           makes them anew from the mirrored centre and the old radius.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q sympy==1.14.0 mpmath==1.3.0 || exit 2
cat > mirror.py <<'PY'
from sympy import Circle, Line

mirrored = Circle((0, 0), 1).reflect(Line((5, 0), (5, 1)))
meets = [tuple(each) for each in mirrored.intersection(Line((0, 0), (1, 0)))]
print(tuple(mirrored.center) == (10, 0), mirrored.radius, mirrored.area, mirrored == Circle((10, 0), 1))
print(mirrored.encloses_point((10, 0)), meets)
PY
seen=$(venv/bin/python mirror.py)
before='True -1 -pi False
False [(9, 0), (11, 0)]'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'sympy-mirrored-circle: as before, sympy 1.14.0 gives radius -1'
