// Radical line.
//
// The difference of the two equations is a line, at right angles to the way v from C1 to C2 and
// a = (d² + r1² - r2²) / 2d along it; it cuts both circles in the same points, half a chord to the left and to the
// right. Touches and circles in one another are told apart by lengths before that.

package main

import "math"

func circleCircle(cx1, cy1, r1, cx2, cy2, r2 float64) ([]Pt, bool) {
	vx, vy := cx2-cx1, cy2-cy1
	near := 1e-10 * largest(r1, r2, vx, vy)
	d, apart := math.Hypot(vx, vy), math.Abs(r1-r2)
	if d <= near {
		switch {
		case r1 == 0 && r2 == 0:
			return []Pt{{cx1, cy1}}, true
		case apart <= near:
			return nil, false
		}
		return nil, true
	}
	ux, uy := vx/d, vy/d
	at := func(along, left float64) Pt {
		return Pt{cx1 + along*ux - left*uy, cy1 + along*uy + left*ux}
	}
	switch {
	case math.Abs(d-(r1+r2)) <= near:
		return []Pt{at(r1, 0)}, true
	case math.Abs(d-apart) <= near:
		return []Pt{at(math.Copysign(r1, r1-r2), 0)}, true
	case d > r1+r2 || d < apart:
		return nil, true
	}
	a := (d + (r1-r2)*((r1+r2)/d)) / 2
	h := math.Sqrt(math.Max(0, (r1-a)*(r1+a)))
	return []Pt{at(a, h), at(a, -h)}, true
}

// largest is the greatest of the magnitudes.
func largest(numbers ...float64) float64 {
	most := 0.0
	for _, x := range numbers {
		most = math.Max(most, math.Abs(x))
	}
	return most
}
