// Relative motion.
//
// Seen from the second disc the first one moves along D, the difference of both ways. Grown to r + s, the second disc
// is met by a point: when does a ray meet a circle? Half a chord before the foot of the perpendicular.

package main

import "math"

func ballsMeet(P0, P1 Pt, r float64, Q0, Q1 Pt, s float64) (float64, bool) {
	reach := r + s
	fx, fy := P0.X-Q0.X, P0.Y-Q0.Y
	dx, dy := (P1.X-P0.X)-(Q1.X-Q0.X), (P1.Y-P0.Y)-(Q1.Y-Q0.Y)
	near := 1e-10 * largest(reach, P1.X-P0.X, P1.Y-P0.Y, fx, fy, Q1.X-P0.X, Q1.Y-P0.Y)
	if math.Hypot(fx, fy) <= reach+near {
		return 0, true
	}
	length := math.Hypot(dx, dy)
	if length == 0 {
		return 0, false
	}
	d := math.Abs(dx*fy-dy*fx) / length
	if d > reach+near {
		return 0, false
	}
	first := -(dx*fx + dy*fy) / length
	if d < reach-near {
		first -= math.Sqrt((reach - d) * (reach + d))
	}
	return first / length, 0 <= first && first <= length+near
}

// largest is the greatest of the magnitudes.
func largest(numbers ...float64) float64 {
	most := 0.0
	for _, x := range numbers {
		most = math.Max(most, math.Abs(x))
	}
	return most
}
