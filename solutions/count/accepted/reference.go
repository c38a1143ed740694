// Distance from the cross product.
//
// Seen from the centre, the cross product of B - A and A - C is |B - A| times the distance of the line from C, and
// keeps its precision wherever A and B lie along the line. The distance is compared with r within 1e-10 of the
// size.

package main

import "math"

func lineCount(cx, cy, r float64, A, B Pt) (int, bool) {
	if A == B {
		return 0, false
	}
	ax, ay, bx, by := A.X-cx, A.Y-cy, B.X-cx, B.Y-cy
	dx, dy := B.X-A.X, B.Y-A.Y
	near := 1e-10 * largest(r, ax, ay, bx, by)
	gap := math.Abs(dx*ay-dy*ax)/math.Hypot(dx, dy) - r
	switch {
	case gap > near:
		return 0, true
	case gap < -near:
		return 2, true
	}
	return 1, true
}

// largest is the greatest of the magnitudes.
func largest(numbers ...float64) float64 {
	most := 0.0
	for _, x := range numbers {
		most = math.Max(most, math.Abs(x))
	}
	return most
}
