// Cross product.
//
// B - A and A - P span a parallelogram whose area is their cross product: divided by the base |B - A| it is the height,
// which is the distance. P is subtracted before anything is multiplied, so that a figure far away keeps its digits.

package main

import "math"

func distance(A, B, P Pt) (float64, bool) {
	if A == B {
		return 0, false
	}
	dx, dy := B.X-A.X, B.Y-A.Y
	fx, fy := A.X-P.X, A.Y-P.Y
	return math.Abs(dx*fy-dy*fx) / math.Hypot(dx, dy), true
}
