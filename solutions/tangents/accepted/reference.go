// Polar.
//
// C, P and a point T where the tangent touches are a right-angled triangle with the long side d = |P - C|. The foot
// of T on the line from C to P is r²/d away from C, and T is r·h/d beside it, where h = √(d² - r²) is the tangent's
// length.

package main

import "math"

func tangentPoints(cx, cy, r float64, P Pt) []Pt {
	if r == 0 {
		return []Pt{{cx, cy}}
	}
	fx, fy := P.X-cx, P.Y-cy
	near := 1e-10 * math.Max(r, math.Max(math.Abs(fx), math.Abs(fy)))
	d := math.Hypot(fx, fy)
	switch {
	case d < r-near:
		return nil
	case d <= r+near:
		return []Pt{P}
	}
	h := math.Sqrt((d - r) * (d + r))
	along, beside := (r/d)*(r/d), (r/d)*(h/d)
	return []Pt{ // the left of P→C is the right of C→P: (fy, -fx)
		{cx + along*fx + beside*fy, cy + along*fy - beside*fx},
		{cx + along*fx - beside*fy, cy + along*fy + beside*fx},
	}
}
