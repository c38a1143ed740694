// Half-open edges.
//
// Each edge has its first corner and not its last one, which is the first one of the next edge: so a corner is met
// once. From the foot of the perpendicular the crossings are half a chord back and forth, as lengths from the first
// corner; the nearer one comes first, and edges come in their order, so that nothing is sorted.

package main

import "math"

func boundaryHits(cx, cy, r float64, V []Pt) []PairIntPt {
	size := r
	for _, p := range V {
		size = math.Max(size, math.Max(math.Abs(p.X-cx), math.Abs(p.Y-cy)))
	}
	near := 1e-10 * size
	var hits []PairIntPt
	for i, p := range V {
		q := V[(i+1)%len(V)]
		fx, fy := p.X-cx, p.Y-cy
		dx, dy := (q.X-cx)-fx, (q.Y-cy)-fy
		length := math.Hypot(dx, dy)
		ux, uy := dx/length, dy/length
		d := math.Abs(ux*fy - uy*fx)
		if d > r+near {
			continue
		}
		foot := -(fx*ux + fy*uy)
		ways := []float64{foot}
		if d < r-near {
			half := math.Sqrt((r - d) * (r + d))
			ways = []float64{foot - half, foot + half}
		}
		for _, way := range ways {
			if -near <= way && way < length-near {
				hits = append(hits, PairIntPt{i, Pt{p.X + way*ux, p.Y + way*uy}})
			}
		}
	}
	return hits
}
