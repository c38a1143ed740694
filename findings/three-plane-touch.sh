#!/bin/sh
# In three.js a segment that ends on a plane meets it, and does not.
#
# Asked:    do Plane.intersectsLine and Plane.intersectLine agree on the segment from (0, 0, 0) to (0, 0, 5)
#           and the plane z = 0?
# Guess:    yes, whatever they answer: one says whether, the other where.
# Seen:     three 0.187.0: intersectsLine is false, intersectLine gives (0, 0, 0). In the plane itself, from
#           (0, 0, 0) to (5, 0, 0), again false and a point. Spheres and boxes that touch do meet:
#           intersectsPlane and intersectsBox are true.
# So:       whoever skips the second call where the first says no loses touches and segments in the plane; ask
#           intersectLine alone, and compare with null.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --no-audit --no-fund --silent three@0.187.0 || exit 2
cat > touch.mjs <<'JS'
import { Box3, Line3, Plane, Sphere, Vector3 } from "three";

const at = (x, y, z) => new Vector3(x, y, z), plane = new Plane(at(0, 0, 1), 0);
for (const end of [at(0, 0, 5), at(5, 0, 0)]) {
    const segment = new Line3(at(0, 0, 0), end);
    console.log(plane.intersectsLine(segment), plane.intersectLine(segment, at(0, 0, 0))?.toArray().join());
}
const sphere = new Sphere(at(0, 0, 1), 1), box = new Box3(at(0, 0, 0), at(1, 1, 1));
console.log(sphere.intersectsPlane(plane), box.intersectsPlane(plane));
JS
seen=$(node touch.mjs)
before='false 0,0,0
false 0,0,0
true true'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'three-plane-touch: as before, three 0.187.0 says no and gives the point'
