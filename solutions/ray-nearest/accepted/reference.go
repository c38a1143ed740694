// Half-chord and the power of the origin.
//
// Half a chord before and after the foot of the perpendicular are both crossings. The one that would be a difference of
// two nearly equal lengths is taken from the other one instead: their product is the power of the origin.

package main

import "math"

func rayNearest(cx, cy, r float64, O, D Pt) (float64, bool) {
	length := math.Hypot(D.X, D.Y)
	if length == 0 {
		return 0, false
	}
	ux, uy := D.X/length, D.Y/length
	fx, fy := O.X-cx, O.Y-cy
	near := 1e-10 * math.Max(r, math.Max(math.Abs(fx), math.Abs(fy)))

	d := math.Abs(D.X*fy-D.Y*fx) / length
	toFoot := -(fx*ux + fy*uy)
	if d > r+near {
		return 0, false
	}
	first, second := toFoot, toFoot
	if d < r-near {
		far := toFoot + math.Copysign(math.Sqrt((r-d)*(r+d)), toFoot)
		other := (fx*fx + fy*fy - r*r) / far
		first, second = math.Min(far, other), math.Max(far, other)
	}
	for _, where := range []float64{first, second} {
		if math.Abs(where) <= near {
			return 0, true
		}
		if where > 0 {
			return where / length, true
		}
	}
	return 0, false
}
