// Half-chord.
//
// The centre, the foot of the perpendicular and an end of the chord are a right-angled triangle with the long side r.
// Whether the line touches is decided by lengths, before any root is taken, and under the root stands (r - d)(r + d),
// which keeps its digits where d is close to r.

package main

import "math"

func chordLength(cx, cy, r float64, A, B Pt) (float64, bool) {
	if A == B {
		return 0, false
	}
	dx, dy := B.X-A.X, B.Y-A.Y
	fx, fy := A.X-cx, A.Y-cy
	near := 1e-10 * largest(r, fx, fy, B.X-cx, B.Y-cy)
	d := math.Abs(dx*fy-dy*fx) / math.Hypot(dx, dy)
	switch {
	case d > r+near:
		return 0, false
	case d >= r-near:
		return 0, true
	}
	return 2 * math.Sqrt((r-d)*(r+d)), true
}

// largest is the greatest of the magnitudes.
func largest(numbers ...float64) float64 {
	most := 0.0
	for _, x := range numbers {
		most = math.Max(most, math.Abs(x))
	}
	return most
}
