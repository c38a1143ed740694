// Distance.
//
// The distance of P from the centre is compared with the radius, within a small part of the case's extent. Anything
// between the band of 1e-12 and the first real miss at 1e-7 decides rightly, and 1e-10 has room on both sides.

package main

import "math"

func onCircle(cx, cy, r float64, P Pt) int {
	fx, fy := P.X-cx, P.Y-cy
	near := 1e-10 * math.Max(r, math.Max(math.Abs(fx), math.Abs(fy)))
	gap := math.Hypot(fx, fy) - r
	switch {
	case gap > near:
		return 1
	case gap < -near:
		return -1
	}
	return 0
}
