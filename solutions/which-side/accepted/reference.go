// Cross product.
//
// The cross product of B - A and P - A is twice the area of the triangle A, B, P, and its sign says which way round the
// three points go. Whole numbers keep it exact: with coordinates up to 1e9 it is at most 8e18, which fits into 64 bits.

package main

func whichSide(A, B, P IntPt) int {
	cross := (B.X-A.X)*(P.Y-A.Y) - (B.Y-A.Y)*(P.X-A.X)
	switch {
	case cross > 0:
		return 1
	case cross < 0:
		return -1
	}
	return 0
}
