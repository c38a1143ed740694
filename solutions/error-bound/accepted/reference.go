// Running error analysis.
//
// Beside Δ in doubles goes a bound of its roundings, each at most u = 2⁻⁵³ of its result: k is off by less than 4·u·m
// with m = |p| + |q|, so k² by 8·u·m·|k| + 16·u²·m², and r²·a by 8·u of itself. The constants are larger by half, for
// the bound is rounded as well. No term is larger than what Δ is made of, so the bound is narrow.

package main

import "math"

func deltaEnclosure(cx, cy, r, ax, ay, bx, by float64) Enclosure {
	const u = 1.0 / (1 << 53)
	dx, dy, fx, fy := bx-ax, by-ay, ax-cx, ay-cy
	p, q := dx*fy, dy*fx
	k, m := p-q, math.Abs(p)+math.Abs(q)
	reach := r * r * (dx*dx + dy*dy)
	delta := reach - k*k
	bound := u*(12*reach+16*m*math.Abs(k)) + 64*u*u*m*m
	if bound == 0 {
		return Enclosure{0, 0}
	}
	return Enclosure{math.Nextafter(delta-bound, math.Inf(-1)), math.Nextafter(delta+bound, math.Inf(1))}
}
