// One loop.
//
// The line's direction and length are the same for all circles and taken once. Then each circle is a cross product, a
// distance and a size of its own, without a call or a root in the loop.

package main

import "math"

func countMany(cx, cy, r []float64, A, B Pt) []int {
	dx, dy := B.X-A.X, B.Y-A.Y
	length := math.Hypot(dx, dy)
	counts := make([]int, len(cx))
	for i, radius := range r {
		fx, fy, gx, gy := A.X-cx[i], A.Y-cy[i], B.X-cx[i], B.Y-cy[i]
		gap := math.Abs(dx*fy-dy*fx)/length - radius
		size := radius
		for _, x := range [...]float64{fx, fy, gx, gy} {
			if far := math.Abs(x); far > size {
				size = far
			}
		}
		switch near := 1e-10 * size; {
		case gap < -near:
			counts[i] = 2
		case gap <= near:
			counts[i] = 1
		}
	}
	return counts
}
