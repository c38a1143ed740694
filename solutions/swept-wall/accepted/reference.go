// Fat wall.
//
// The disc is made a point and the wall grown by r: two sides, and a cap around each end. The distance from the wall's
// line changes evenly, and is r at one moment on the side that P0 is on; each cap is a circle that a ray meets. The
// first of these moments is the answer.

package main

import "math"

func timeOfImpact(P0, P1 Pt, r float64, A, B Pt) (float64, bool) {
	d, w, f, g := minus(P1, P0), minus(B, A), minus(P0, A), minus(P0, B)
	size := r
	for _, v := range []Pt{f, g, minus(P1, A), minus(P1, B)} {
		size = math.Max(size, math.Max(math.Abs(v.X), math.Abs(v.Y)))
	}
	near := 1e-10 * size
	way, wall := math.Hypot(d.X, d.Y), math.Hypot(w.X, w.Y)

	height, foot := 0.0, 0.0 // of P0 above the wall's line, and how far along it
	if wall > 0 {
		height, foot = cross(w, f)/wall, dot(w, f)/wall
	}
	start := math.Min(math.Hypot(f.X, f.Y), math.Hypot(g.X, g.Y))
	if 0 < foot && foot < wall {
		start = math.Abs(height)
	}
	if start <= r+near {
		return 0, true
	}
	if way == 0 {
		return 0, false
	}

	first := math.Inf(1)
	for _, v := range []Pt{f, g} { // the caps
		away, meets := math.Abs(cross(d, v))/way, -dot(d, v)/way
		if away > r+near {
			continue
		}
		if away < r-near {
			meets -= math.Sqrt((r - away) * (r + away))
		}
		first = math.Min(first, meets/way)
	}
	if turn := cross(w, d); turn != 0 { // the side
		t := (math.Copysign(r, height) - height) / turn * wall
		if at := foot + t*dot(d, w)/wall; 0 <= at && at <= wall {
			first = math.Min(first, t)
		}
	}
	return first, 0 <= first && (first-1)*way <= near
}

func minus(u, v Pt) Pt      { return Pt{u.X - v.X, u.Y - v.Y} }
func dot(u, v Pt) float64   { return u.X*v.X + u.Y*v.Y }
func cross(u, v Pt) float64 { return u.X*v.Y - u.Y*v.X }
