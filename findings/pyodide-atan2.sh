#!/bin/sh
# Every sixth angle that Python computes in a browser tab differs from Python's in a terminal.
#
# Asked:    is math.atan2(y, x) for whole 1 <= x, y <= 40 the double nearest to the angle, in Pyodide too?
# Guess:    in all but a few, as in CPython on Linux: it is the same CPython, and WebAssembly's doubles are
#           IEEE's.
# Seen:     pyodide 314.0.7 (Python 3.14.2): 248 of 1600 are the double beside it; in CPython with glibc 2.36
#           it is 3. Its mathematical library is another one, of the family that JavaScript engines use:
#           Math.atan2 of node 24.11.1 gives the same bits in all 1600.
# So:       angles that are compared with ==, sorted, or hashed as keys can come out otherwise on a web page
#           than in a terminal: compare directions by cross products, and angles with a tolerance. math.hypot
#           and sqrt gave the same bits.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --no-audit --no-fund --silent pyodide@314.0.7 node@24.11.1 || exit 2
cat > nearest.py <<'PY'
from decimal import Decimal, getcontext

getcontext().prec = 50


def atan(x):
    """By halving the angle until the series converges fast."""
    factor = 1
    while x > Decimal("0.01"):
        x, factor = x / (1 + (1 + x * x).sqrt()), 2 * factor
    total, power, n = Decimal(0), x, 1
    while abs(power) > Decimal("1e-48"):
        total, power, n = total + power / n, -power * x * x, n + 2
    return factor * total


print([float(atan(Decimal(y) / x)) for y in range(1, 41) for x in range(1, 41)])
PY
cat > angles.mjs <<'JS'
import { readFileSync } from "node:fs";
import { loadPyodide } from "pyodide";

const nearest = JSON.parse(readFileSync("nearest.json")), pyodide = await loadPyodide(), javascript = [];
const python = pyodide.runPython(
    "import math\n[math.atan2(y, x) for y in range(1, 41) for x in range(1, 41)]",
).toJs();
for (let y = 1; y <= 40; y++) for (let x = 1; x <= 40; x++) javascript.push(Math.atan2(y, x));
const differ = (one, other) => one.filter((each, i) => each !== other[i]).length;
console.log(python.length, differ(python, nearest), differ(python, javascript));
JS
python3 nearest.py > nearest.json
seen=$(./node_modules/.bin/node angles.mjs)
before='1600 248 0'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'pyodide-atan2: as before, 248 of 1600 angles of pyodide 314.0.7 are not the nearest double'
