#!/bin/sh
# geometer's circle has twice the area of a circle.
#
# Asked:    the area of the circle of radius 5 around (1, 2), and volume and surface of the sphere of radius
#           2.
# Guess:    78.540, 33.510, 50.265: formulas that every library has right.
# Seen:     geometer 0.4.2: Circle.area is 157.080, 2 pi r²; Sphere.volume and Sphere.area are right, centre
#           and radius too.
# So:       whoever compares areas of circles and polygons (whose area is right) with it decides wrongly; use
#           radius.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q geometer==0.4.2 numpy==2.4.6 || exit 2
cat > area.py <<'PY'
from geometer import Circle, Point, Polygon, Sphere

circle, sphere = Circle(Point(1, 2), 5), Sphere(Point(0, 0, 0), 2)
square = Polygon(Point(0, 0), Point(2, 0), Point(2, 2), Point(0, 2))
print(*(f"{each:.3f}" for each in (circle.radius, circle.area, sphere.volume, sphere.area, square.area)))
PY
seen=$(venv/bin/python area.py)
before='5.000 157.080 33.510 50.265 4.000'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'geometer-circle-area: as before, 157.080 for radius 5 in geometer 0.4.2'
