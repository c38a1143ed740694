// Foot and half-chord.
//
// The foot of the perpendicular from the centre is the middle of both points: half a chord before it the ray enters,
// half a chord after it it leaves. The distance of the line from the centre is the cross product of its unit vector
// and f = O - C. The way from C to the point is the normal, r long; where the ray leaves it is turned round.

package main

import "math"

func raySphere(C Pt3, r float64, O, D Pt3) (PairRealPt3, bool) {
	length := norm(D)
	if length == 0 || r == 0 {
		return PairRealPt3{}, false
	}
	u := Pt3{D.X / length, D.Y / length, D.Z / length}
	f := Pt3{O.X - C.X, O.Y - C.Y, O.Z - C.Z}
	near := 1e-10 * math.Max(math.Max(r, math.Abs(f.X)), math.Max(math.Abs(f.Y), math.Abs(f.Z)))
	d := norm(Pt3{u.Y*f.Z - u.Z*f.Y, u.Z*f.X - u.X*f.Z, u.X*f.Y - u.Y*f.X})
	gap := r - d
	if gap < -near {
		return PairRealPt3{}, false
	}
	foot, half := -(u.X*f.X + u.Y*f.Y + u.Z*f.Z), 0.0
	if gap > near {
		half = math.Sqrt(gap * (r + d))
	}
	at := func(way, radius float64) PairRealPt3 {
		t := way / length
		if way <= near {
			t, way = 0, 0
		}
		return PairRealPt3{t, Pt3{(f.X + way*u.X) / radius, (f.Y + way*u.Y) / radius, (f.Z + way*u.Z) / radius}}
	}
	switch {
	case foot-half >= -near:
		return at(foot-half, r), true
	case foot+half >= -near:
		return at(foot+half, -r), true
	}
	return PairRealPt3{}, false
}

// norm is the length of a vector, of any size: its square might be too small for a double, or too large.
func norm(v Pt3) float64 { return math.Hypot(math.Hypot(v.X, v.Y), v.Z) }
