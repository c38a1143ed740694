// Squares.
//
// Two lengths compare as their squares do, and squares of whole numbers are exact: with coordinates up to 1e9 they are
// at most 8e18, which fits into 64 bits.

package main

func circleSide(cx, cy, r int, P IntPt) int {
	dx, dy := P.X-cx, P.Y-cy
	square := dx*dx + dy*dy
	switch {
	case square < r*r:
		return -1
	case square > r*r:
		return 1
	}
	return 0
}
