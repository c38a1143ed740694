#!/bin/sh
# fraction.js makes 0 of small numbers, from 9e-8 down.
#
# Asked:    what fraction is the number 1e-8, a gap or a tolerance of a geometry program?
# Guess:    1/100000000: the nearest simple fraction, as the package finds 1/3 for 0.3333333333333333; or at
#           worst one that is near, as relative error goes.
# Seen:     fraction.js 5.3.4: 1e-7 is 1/10000000, but 9e-8, 1e-8 and 3e-9 are 0, without an error: it looks
#           for denominators up to a limit, by absolute distance. The text "0.00000001" gives 1/100000000.
#           123456789.123456789 is off by 1.00. Python's Fraction(1e-8) is the double exactly.
# So:       whoever turns to fractions so that a touch is decided exactly must pass numbers as texts, or as
#           [numerator, denominator]; README speaks of large numbers only.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --no-audit --no-fund --silent fraction.js@5.3.4 || exit 2
cat > small.js <<'JS'
const Fraction = require("fraction.js");
for (const x of [1 / 3, 1e-7, 9e-8, 1e-8, 3e-9, "0.00000001"]) console.log(x, new Fraction(x).toFraction());
console.log((new Fraction(123456789.123456789).valueOf() - 123456789.123456789).toFixed(2));
JS
seen=$(node small.js)
before='0.3333333333333333 1/3
1e-7 1/10000000
9e-8 0
1e-8 0
3e-9 0
0.00000001 1/100000000
1.00'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'fraction-js-small-numbers: as before, fraction.js 5.3.4 makes 0 of 1e-8'
