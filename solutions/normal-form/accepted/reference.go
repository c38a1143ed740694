// Perpendicular.
//
// The direction (dx, dy) turned to the left by a quarter is (-dy, dx). Made one long, its product with the way from A
// to a point says how far that point is to the left of the line; what is left of it without x and y is c.

package main

import "math"

func normalForm(A, B Pt) (Pt3, bool) {
	if A == B {
		return Pt3{}, false
	}
	dx, dy := B.X-A.X, B.Y-A.Y
	length := math.Hypot(dx, dy)
	a, b := -dy/length, dx/length
	return Pt3{a, b, -(a*A.X + b*A.Y)}, true
}
