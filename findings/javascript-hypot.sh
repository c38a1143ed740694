#!/bin/sh
# Math.hypot of JavaScript is not exact where the hypotenuse is a small whole number.
#
# Guess:    whole sides whose hypotenuse is whole, all below 2**18, give exactly that number, as in Python:
#           hypot is the careful routine, and √(a² + b²) the careless one.
# Seen:     node 24.11.1 (V8): Math.hypot(45, 108) is 116.99999999999999, not 117. Of 39,800 primitive triples
#           with m < 400 it misses 10,168; Math.sqrt(a * a + b * b) misses none, nor does CPython's
#           math.hypot.
# So:       a program that asks `Math.hypot(x, y) === r` calls every fourth such point off the circle, and its
#           copy in Python none: the two need a tolerance, or squares of whole numbers.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --no-audit --no-fund --silent node@24.11.1 || exit 2
cat > count.js <<'JS'
let triples = 0, hypot = 0, root = 0;
for (let m = 2; m < 400; m++) for (let n = 1 + m % 2; n < m; n += 2) {
    const a = m * m - n * n, b = 2 * m * n, c = m * m + n * n;
    triples++;
    hypot += Math.hypot(a, b) !== c;
    root += Math.sqrt(a * a + b * b) !== c;
}
console.log(triples, hypot, root, Math.hypot(45, 108));
JS
cat > count.py <<'PY'
from math import hypot

triples = [(m * m - n * n, 2 * m * n, m * m + n * n) for m in range(2, 400) for n in range(1 + m % 2, m, 2)]
print(len(triples), sum(hypot(a, b) != c for a, b, c in triples), hypot(45, 108))
PY
seen=$(./node_modules/.bin/node count.js && python3 count.py)
before='39800 10168 0 116.99999999999999
39800 0 117.0'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'javascript-hypot: as before, Math.hypot of node 24.11.1 misses 10168 of 39800 whole hypotenuses'
