#!/bin/sh
# A segment query of pymunk that starts in a shape says "at 0 of the way", and the point at its end.
#
# Asked:    what does segment_query answer for a segment from (1, 0) to (10, 0) and a circle of radius 5 about
#           (0, 0)?
# Guess:    no hit, as Box2D does, or the start with alpha 0, or where it leaves, (5, 0), with alpha 4/9.
# Seen:     pymunk 7.3.1: alpha is 0 and the point is (10, 0), which is neither in the circle nor on it; the
#           normal looks inwards. The same from (5, 0), a point of the circle, with the normal (0, 0), so that
#           a ray that goes on from where the last one hit is never free. A segment inside, of (0, 0) to
#           (1, 0), is a hit, too. From outside all three belong together.
# So:       alpha says whether it began inside; take the point only where alpha is more than 0.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q pymunk==7.3.1 || exit 2
cat > inside.py <<'PY'
import pymunk

space = pymunk.Space()
body = pymunk.Body(body_type=pymunk.Body.STATIC)
circle = pymunk.Circle(body, 5)
space.add(body, circle)
for start, end in (((-10, 0), (10, 0)), ((1, 0), (10, 0)), ((5, 0), (10, 0)), ((0, 0), (1, 0))):
    hit = circle.segment_query(start, end)
    same = space.segment_query_first(start, end, 0, pymunk.ShapeFilter())
    print(hit.alpha, *map(int, hit.point), *map(int, hit.normal), same.point == hit.point)
PY
seen=$(venv/bin/python inside.py)
before='0.25 -5 0 -1 0 True
0.0 10 0 -1 0 True
0.0 10 0 0 0 True
0.0 1 0 0 0 True'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'pymunk-query-inside: as before, pymunk 7.3.1 has alpha 0 and the point at the end'
