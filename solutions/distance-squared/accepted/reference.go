// Pythagoras.
//
// The ways along x and along y are the short sides of a right-angled triangle, and the distance is its long side. With
// coordinates up to 1e9 the sum of the squares is at most 8e18, which fits into 64 bits.

package main

func distanceSquared(P, Q IntPt) int {
	dx, dy := Q.X-P.X, Q.Y-P.Y
	return dx*dx + dy*dy
}
