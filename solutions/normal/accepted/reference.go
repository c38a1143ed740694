// Hit from the centre.
//
// The hit as seen from C is r long: divided by r it is the normal that points outward. Where the ray leaves the circle
// it is turned round. Nothing is added to C, for far from the origin the point itself would have no digits left.

package main

import "math"

func hitNormal(cx, cy, r float64, O, D Pt) (Pt, bool) {
	length := math.Hypot(D.X, D.Y)
	if r == 0 || length == 0 {
		return Pt{}, false
	}
	ux, uy := D.X/length, D.Y/length
	fx, fy := O.X-cx, O.Y-cy
	near := 1e-10 * math.Max(r, math.Max(math.Abs(fx), math.Abs(fy)))

	d := math.Abs(D.X*fy-D.Y*fx) / length
	if d > r+near {
		return Pt{}, false
	}
	toFoot, half := -(fx*ux + fy*uy), 0.0
	if d < r-near {
		half = math.Sqrt((r - d) * (r + d))
	}
	if way := toFoot - half; way >= -near { // it enters, or touches
		return Pt{(fx + way*ux) / r, (fy + way*uy) / r}, true
	}
	if way := toFoot + half; way >= -near { // it leaves
		return Pt{-(fx + way*ux) / r, -(fy + way*uy) / r}, true
	}
	return Pt{}, false
}
