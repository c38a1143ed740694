// Right angle.
//
// By Thales' theorem P is on the circle exactly where A and B are seen from it at a right angle, which makes their
// scalar product 0. Inside the angle is wider and the product below 0, outside it is above 0. No half is ever needed.

package main

func diameterSide(A, B, P IntPt) int {
	dot := (A.X-P.X)*(B.X-P.X) + (A.Y-P.Y)*(B.Y-P.Y)
	switch {
	case dot < 0:
		return -1
	case dot > 0:
		return 1
	}
	return 0
}
