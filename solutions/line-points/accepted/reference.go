// Foot and half-chord.
//
// The foot of the perpendicular from the centre is the middle of both points: it is found from C, along the normal, and
// not from A, however far away that is. From there half the chord goes back and forth along the line, in the order of
// A to B.

package main

import "math"

func linePoints(cx, cy, r float64, A, B Pt) ([]Pt, bool) {
	if A == B {
		return nil, false
	}
	dx, dy := B.X-A.X, B.Y-A.Y
	fx, fy := A.X-cx, A.Y-cy
	near := 1e-10 * largest(r, fx, fy, B.X-cx, B.Y-cy)
	length := math.Hypot(dx, dy)
	ux, uy := dx/length, dy/length
	side := ux*fy - uy*fx // of the line from the centre, along the left normal (-uy, ux)
	foot := Pt{cx - side*uy, cy + side*ux}
	gap := r - math.Abs(side)
	if gap < -near {
		return nil, true
	}
	if gap <= near {
		return []Pt{foot}, true
	}
	half := math.Sqrt(gap * (r + math.Abs(side)))
	return []Pt{{foot.X - half*ux, foot.Y - half*uy}, {foot.X + half*ux, foot.Y + half*uy}}, true
}

// largest is the greatest of the magnitudes.
func largest(numbers ...float64) float64 {
	most := 0.0
	for _, x := range numbers {
		most = math.Max(most, math.Abs(x))
	}
	return most
}
