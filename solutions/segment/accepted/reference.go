// Half-chord from the foot.
//
// The foot of the perpendicular from the centre is the middle of both crossings: half a chord goes back and forth from
// it along the line. What is on the segment is decided by lengths along the line, within 1e-10 of the size.

package main

import "math"

func circleSegment(cx, cy, r float64, A, B Pt) []Pt {
	ax, ay := A.X-cx, A.Y-cy
	dx, dy := B.X-A.X, B.Y-A.Y
	near := 1e-10 * largest(r, ax, ay, B.X-cx, B.Y-cy)
	length := math.Hypot(dx, dy)
	if length == 0 {
		if math.Abs(math.Hypot(ax, ay)-r) <= near {
			return []Pt{A}
		}
		return nil
	}
	ux, uy := dx/length, dy/length
	side := ux*ay - uy*ax // of the line from the centre, along the left normal (-uy, ux)
	toFoot := -(ux*ax + uy*ay)
	foot := Pt{cx - side*uy, cy + side*ux}

	var steps []float64
	switch d := math.Abs(side); {
	case d > r+near:
	case d >= r-near:
		steps = []float64{0}
	default:
		half := math.Sqrt((r - d) * (r + d))
		steps = []float64{-half, half}
	}
	var points []Pt
	for _, step := range steps {
		if where := toFoot + step; -near <= where && where <= length+near {
			points = append(points, Pt{foot.X + step*ux, foot.Y + step*uy})
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
