// Normals.
//
// A tangent has a unit normal n with X·n = r1 seen from C1; the other centre v is r2 away from it, on the same side or
// beyond it: v·n = q with q = r1 - r2 or r1 + r2. So n is q/d along v and √(1 - q²/d²) beside it, and the point is
// C1 + r1·n. Where d = |q| both tangents are one, where d < |q| there is none.

package main

import "math"

func commonTangents(cx1, cy1, r1, cx2, cy2, r2 float64) []Pt {
	vx, vy := cx2-cx1, cy2-cy1
	near := 1e-10 * largest(r1, r2, vx, vy)
	d := math.Hypot(vx, vy)
	ux, uy := vx/d, vy/d
	at := func(along, left float64) Pt {
		return Pt{cx1 + r1*(along*ux-left*uy), cy1 + r1*(along*uy+left*ux)}
	}
	var points []Pt
	for _, q := range []float64{r1 - r2, r1 + r2} {
		switch gap := d - math.Abs(q); {
		case gap < -near:
		case gap <= near:
			points = append(points, at(math.Copysign(1, q), 0))
		default:
			along, left := q/d, math.Sqrt((d-q)*(d+q))/d
			points = append(points, at(along, left), at(along, -left))
		}
	}
	return points
}

// largest is the greatest of the magnitudes.
func largest(numbers ...float64) float64 {
	most := 0.0
	for _, x := range numbers {
		most = math.Max(most, math.Abs(x))
	}
	return most
}
