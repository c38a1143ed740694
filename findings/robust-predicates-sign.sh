#!/bin/sh
# robust-predicates and Shewchuk's orient2d answer with opposite signs, its incircle with the same.
#
# Asked:    what sign has orient2d of a, b, c that turn left, y upwards, and incircle of a point within their
#           circle?
# Guess:    both positive, as in Shewchuk's C, of which the package is a port, and as its README says where it
#           speaks of orient2d.
# Seen:     robust-predicates 3.0.3: orient2d of (0, 0), (1, 0), (0, 1) is -1, as is orient3d of the unit
#           corner. incircle of (1, 0), (0, 1), (-1, 0) and the centre is 2: with y upwards it is positive
#           within, as Shewchuk's. One line of README tells it: y points downwards there.
# So:       whoever moves a program between C or Python and JavaScript turns the sign of orient2d, but not of
#           incircle. What README says of points outside holds for points in its own counterclockwise order,
#           which is clockwise with y upwards.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --no-audit --no-fund --silent robust-predicates@3.0.3 || exit 2
cat > sign.mjs <<'JS'
import { incircle, orient2d, orient3d } from "robust-predicates";

const left = orient2d(0, 0, 1, 0, 0, 1), corner = orient3d(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
console.log(left, corner, incircle(1, 0, 0, 1, -1, 0, 0, 0));
JS
seen=$(node sign.mjs)
before='-1 -1 2'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'robust-predicates-sign: as before, robust-predicates 3.0.3 gives -1 for a left turn, 2 within'
