#!/bin/sh
# In scikit-spatial a line of whole numbers touches the sphere, and misses the circle that is cut out of it.
#
# Asked:    does the line through (3, 4) along (4, -3) meet the circle of radius 5 about (0, 0)?
# Guess:    yes, as two equal points: its page says so of tangents, and every product of these numbers is a
#           small int.
# Seen:     scikit-spatial 10.0.0: Circle.intersect_line raises "does not intersect", for it makes the direction
#           a unit vector first. Of 999 tangents at k·(3, 4), radius 5·k, it finds 540; along an axis all.
#           Sphere.intersect_line, in the plane z = 0, finds all 999.
# So:       a line that touches must be asked as one in space; two circles that touch are found.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q scikit-spatial==10.0.0 numpy==2.4.6 || exit 2
cat > touch.py <<'PY'
from skspatial.objects import Circle, Line, Sphere


def met(shape, point, way):
    try:
        return len(shape.intersect_line(Line(point, way)))
    except ValueError:
        return 0


some = range(1, 1000)
print(met(Circle([0, 0], 5), [3, 4], [4, -3]), met(Sphere([0, 0, 0], 5), [3, 4, 0], [4, -3, 0]))
print(300 < sum(met(Circle([0, 0], 5 * k), [3 * k, 4 * k], [4, -3]) > 0 for k in some) < 800)
print(sum(met(Circle([0, 0], 5 * k), [5 * k, 0], [0, 1]) > 0 for k in some))
print(sum(met(Sphere([0, 0, 0], 5 * k), [3 * k, 4 * k, 0], [4, -3, 0]) > 0 for k in some))
print(len(Circle([0, 0], 5).intersect_circle(Circle([6, 8], 5))))
PY
seen=$(venv/bin/python touch.py)
before='0 2
True
999
999
2'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'skspatial-circle-sphere: as before, scikit-spatial 10.0.0 has a tangent of the sphere alone'
