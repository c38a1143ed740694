// Cross product.
//
// The distance of C from the line is |k| / |B - A|, with the cross product k of B - A and C - A. Squared and multiplied
// by |B - A|², it is compared with r in whole numbers: nothing is divided and no root is taken.

package main

func crossings(cx, cy, r int, A, B IntPt) int {
	dx, dy := B.X-A.X, B.Y-A.Y
	k := dx*(cy-A.Y) - dy*(cx-A.X)
	away, reach := k*k, r*r*(dx*dx+dy*dy)
	switch {
	case away < reach:
		return 2
	case away > reach:
		return 0
	}
	return 1
}
