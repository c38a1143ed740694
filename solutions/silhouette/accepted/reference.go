// State machine.
//
// One bit is remembered from frame to frame: whether a hit was shown last. After a hit the radius r·(1 + h) counts, and
// after a miss r·(1 - h); the first frame compares with r itself. A threshold is passed only by more than 1e-10 of the
// frame's size, so that rounding never passes one.

package main

import "math"

func steadyHits(circles []Circle, O, D Pt, h float64) []int {
	length := math.Hypot(D.X, D.Y)
	ux, uy := D.X/length, D.Y/length
	answer := make([]int, len(circles))
	shown := false
	for i, c := range circles {
		fx, fy := O.X-c.X, O.Y-c.Y
		d := math.Abs(ux*fy - uy*fx)
		near := 1e-10 * math.Max(c.R, math.Max(math.Abs(fx), math.Abs(fy)))
		switch {
		case i == 0:
			shown = d < c.R
		case shown:
			shown = d <= c.R*(1+h)+near
		default:
			shown = d < c.R*(1-h)-near
		}
		if shown {
			answer[i] = 1
		}
	}
	return answer
}
