// Dot products.
//
// The arrow from A to C is projected onto D, the arrow from A to B: (C - A)·D is |D| times the projection and D·D is
// |D|², so that their quotient is the projection in lengths of D. That is t, and A + t·D is the foot.

package main

func foot(A, B, C Pt) (PairRealPt, bool) {
	if A == B {
		return PairRealPt{}, false
	}
	dx, dy := B.X-A.X, B.Y-A.Y
	t := ((C.X-A.X)*dx + (C.Y-A.Y)*dy) / (dx*dx + dy*dy)
	return PairRealPt{t, Pt{A.X + t*dx, A.Y + t*dy}}, true
}
