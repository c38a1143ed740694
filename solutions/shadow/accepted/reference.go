// A least way.
//
// The ray takes the least crossing ahead of it. The second ray goes from that point to the light: any crossing on its
// way casts a shadow, but for those within 1e-9 of the size, which are the point itself. If the ray and the light are
// on different sides of the surface, the point is dark as well.

package main

import "math"

func light(circles []Circle, O, D, L Pt) (string, bool) {
	length := math.Hypot(D.X, D.Y)
	u := Pt{D.X / length, D.Y / length}
	size := math.Max(math.Abs(L.X-O.X), math.Abs(L.Y-O.Y))
	first, own := math.Inf(1), Circle{}
	for _, c := range circles {
		size = math.Max(math.Max(size, c.R), math.Max(math.Abs(c.X-O.X), math.Abs(c.Y-O.Y)))
		for _, way := range ways(c, O, u) {
			if 0 < way && way < first {
				first, own = way, c
			}
		}
	}
	if math.IsInf(first, 1) {
		return "", false
	}
	// Seen from the centre of the circle that is hit, so that nothing is lost far from the plane's origin.
	n := Pt{O.X - own.X + first*u.X, O.Y - own.Y + first*u.Y}
	v := Pt{L.X - own.X - n.X, L.Y - own.Y - n.Y}
	if (u.X*n.X+u.Y*n.Y < 0) != (v.X*n.X+v.Y*n.Y > 0) {
		return "dark", true
	}
	reach := math.Hypot(v.X, v.Y)
	v = Pt{v.X / reach, v.Y / reach}
	for _, c := range circles {
		for _, way := range ways(Circle{c.X - own.X, c.Y - own.Y, c.R}, n, v) {
			if 1e-9*size < way && way < reach {
				return "dark", true
			}
		}
	}
	return "lit", true
}

// ways says how far along the unit vector u the line from P meets the circle: two lengths, or none.
func ways(c Circle, P, u Pt) []float64 {
	fx, fy := P.X-c.X, P.Y-c.Y
	d := math.Abs(u.X*fy - u.Y*fx)
	if d >= c.R {
		return nil
	}
	foot, half := -(fx*u.X + fy*u.Y), math.Sqrt((c.R-d)*(c.R+d))
	return []float64{foot - half, foot + half}
}
