// Distance.
//
// The distance of P from the centre is compared with the radius, within 1e-10 of the size. Rounding is far less than
// that, and the nearest miss, 1e-7, far more.

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
