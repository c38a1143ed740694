#!/bin/sh
# A point inside a polygon is at distance 0 from it in shapely, but not in flatten-js or sympy.
#
# Asked:    the distance from (1, 1) to the square from (0, 0) to (4, 4), by the three libraries, and whether
#           it is inside.
# Guess:    0 and inside, in all: each calls the polygon a region, has `contains` or its like, and an area.
# Seen:     shapely 2.2.0: 0. @flatten-js/core 1.6.15: contains is true, distanceTo is 1, also from the
#           polygon, and from a polygon within it, which it contains as well. sympy 1.14.0: encloses_point is
#           true, distance is 1.
# So:       a program that moves from shapely to the others, or tests `distance <= r` for "the disc meets the
#           polygon", misses every disc that is wholly inside; ask contains first.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q shapely==2.2.0 numpy==2.4.6 sympy==1.14.0 mpmath==1.3.0 || exit 2
npm install --no-audit --no-fund --silent @flatten-js/core@1.6.15 || exit 2
cat > within.py <<'PY'
import shapely
import sympy

square = [(0, 0), (4, 0), (4, 4), (0, 4)]
region, point = shapely.Polygon(square), shapely.Point(1, 1)
print("shapely", region.distance(point), region.contains(point))
region, point = sympy.Polygon(*square), sympy.Point(1, 1)
print("sympy", region.distance(point), region.encloses_point(point))
PY
cat > within.mjs <<'JS'
import flatten from "@flatten-js/core";

const { Polygon, point } = flatten, square = new Polygon([[0, 0], [4, 0], [4, 4], [0, 4]]);
for (const inner of [point(1, 1), new Polygon([[1, 1], [3, 1], [3, 3], [1, 3]])])
    console.log("flatten", square.distanceTo(inner)[0], square.contains(inner));
JS
seen=$(venv/bin/python within.py && node within.mjs)
before='shapely 0.0 True
sympy 1 True
flatten 1 true
flatten 1 true'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'polygon-distance-within: as before, 0 in shapely 2.2.0, 1 in sympy 1.14.0 and flatten-js 1.6.15'
