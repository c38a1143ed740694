// Sort them all.
//
// Each circle gives two hits, one touch or none. The foot of the perpendicular is the middle of both: half a chord
// before it the ray enters, half a chord after it it leaves. The tag goes with the hit before anything is sorted.

package main

import (
	"math"
	"sort"
)

func allHits(circles []Circle, O, D Pt) []TripleRealIntWord {
	size := 0.0
	for _, c := range circles {
		size = math.Max(math.Max(size, c.R), math.Max(math.Abs(c.X-O.X), math.Abs(c.Y-O.Y)))
	}
	near := 1e-10 * size
	length := math.Hypot(D.X, D.Y)
	ux, uy := D.X/length, D.Y/length

	var hits []TripleRealIntWord
	for i, c := range circles {
		add := func(way float64, tag string) {
			if way >= -near {
				hits = append(hits, TripleRealIntWord{math.Max(way, 0) / length, i, tag})
			}
		}
		fx, fy := O.X-c.X, O.Y-c.Y
		d := math.Abs(ux*fy - uy*fx)
		foot := -(fx*ux + fy*uy)
		switch {
		case d > c.R+near:
		case d >= c.R-near:
			add(foot, "touch")
		default:
			half := math.Sqrt((c.R - d) * (c.R + d))
			add(foot-half, "enter")
			add(foot+half, "exit")
		}
	}
	sort.SliceStable(hits, func(a, b int) bool { return hits[a].First < hits[b].First })
	return hits
}
