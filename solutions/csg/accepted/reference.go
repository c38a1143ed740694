// Pieces.
//
// The ray is cut at the ends of all discs; ends that are nearly the same are made one first, so that no piece is a
// sliver. Then a piece is inside the solid as a whole or not at all, and its middle says which: the program is run with
// true and false on its stack.

package main

import (
	"math"
	"sort"
)

func insideSpans(circles []Circle, O, D Pt, program []int) []PairRealReal {
	size := 0.0
	for _, c := range circles {
		size = math.Max(math.Max(size, c.R), math.Max(math.Abs(c.X-O.X), math.Abs(c.Y-O.Y)))
	}
	near := 1e-10 * size
	length := math.Hypot(D.X, D.Y)
	ux, uy := D.X/length, D.Y/length

	discs := make([]PairRealReal, len(circles)) // from where to where the ray is in each; 0 to 0 where it never is
	ends := []float64{0}
	for i, c := range circles {
		fx, fy := O.X-c.X, O.Y-c.Y
		d := math.Abs(ux*fy - uy*fx)
		if d >= c.R-near {
			continue
		}
		foot, half := -(fx*ux + fy*uy), math.Sqrt((c.R-d)*(c.R+d))
		discs[i] = PairRealReal{math.Max(0, foot-half), math.Max(0, foot+half)}
		ends = append(ends, discs[i].First, discs[i].Second)
	}
	sort.Float64s(ends)

	var spans []PairRealReal
	start, joined := 0.0, false
	for _, end := range ends {
		if end-start <= near {
			continue
		}
		inside := holds(program, discs, (start+end)/2)
		if inside && joined {
			spans[len(spans)-1].Second = end / length
		} else if inside {
			spans = append(spans, PairRealReal{start / length, end / length})
		}
		start, joined = end, inside
	}
	return spans
}

// holds says whether the place on the ray is inside the solid.
func holds(program []int, discs []PairRealReal, place float64) bool {
	var stack []bool
	for _, step := range program {
		if step >= 0 {
			stack = append(stack, discs[step].First < place && place < discs[step].Second)
			continue
		}
		top := len(stack) - 1
		lower, upper := stack[top-1], stack[top]
		switch step {
		case -1:
			lower = lower || upper
		case -2:
			lower = lower && upper
		default:
			lower = lower && !upper
		}
		stack = append(stack[:top-1], lower)
	}
	return stack[0]
}
