// Normal part.
//
// D has a part along the normal N = (P - C)/r and a part across it. Taking (D·N)·N away twice turns the first one round
// and leaves the second one, and D keeps its length. N goes in twice, so inside and outside are no different cases.

package main

import "math"

func reflect(cx, cy, r float64, O, D Pt) (PairPtPt, bool) {
	length := math.Hypot(D.X, D.Y)
	if r == 0 || length == 0 {
		return PairPtPt{}, false
	}
	ux, uy := D.X/length, D.Y/length
	fx, fy := O.X-cx, O.Y-cy
	near := 1e-10 * math.Max(r, math.Max(math.Abs(fx), math.Abs(fy)))

	d := math.Abs(D.X*fy-D.Y*fx) / length
	if d > r+near {
		return PairPtPt{}, false
	}
	toFoot, half := -(fx*ux + fy*uy), 0.0
	if d < r-near {
		half = math.Sqrt((r - d) * (r + d))
	}
	for _, way := range []float64{toFoot - half, toFoot + half} {
		if way >= -near {
			nx, ny := (fx+way*ux)/r, (fy+way*uy)/r
			twice := 2 * (D.X*nx + D.Y*ny)
			return PairPtPt{Pt{O.X + way*ux, O.Y + way*uy}, Pt{D.X - twice*nx, D.Y - twice*ny}}, true
		}
	}
	return PairPtPt{}, false
}
