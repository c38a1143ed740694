// A tree over the beams.
//
// Seen from O a circle covers an interval of angles, so a run of the sorted beams; a segment tree cuts the run into a
// few nodes, and the circle goes into the list of each. A beam finds its candidates in the lists from its leaf up to
// the root. They are sorted by their nearest points, so that it stops in each list where no better one can follow.

package main

import (
	"math"
	"sort"
)

const room = 1e-6 // radians around each interval: it only chooses, and the test itself is exact enough

type shape struct {
	index int
	x, y  float64 // the centre as seen from O
	r     float64
	least float64 // how far from O its nearest point is
}

func scan(circles []IntCircle, O IntPt, dirs []IntPt) []*PairIntReal {
	shapes := make([]shape, len(circles))
	size := 0.0
	for i, c := range circles {
		x, y, r := float64(c.X-O.X), float64(c.Y-O.Y), float64(c.R)
		shapes[i] = shape{i, x, y, r, math.Hypot(x, y) - r}
		size = math.Max(math.Max(size, r), math.Max(math.Abs(x), math.Abs(y)))
	}
	near := 1e-10 * size
	tree := planted(shapes, dirs)
	answers := make([]*PairIntReal, len(dirs))
	for i, D := range dirs {
		length := math.Hypot(float64(D.X), float64(D.Y))
		ux, uy := float64(D.X)/length, float64(D.Y)/length
		best, found := math.Inf(1), -1
		for node := i + len(dirs); node > 0; node /= 2 {
			for _, s := range tree[node] {
				if s.least > best {
					break
				}
				if way, ok := s.met(ux, uy, near); ok && way < best {
					best, found = way, s.index
				}
			}
		}
		if found >= 0 {
			answers[i] = &PairIntReal{found, best / length}
		}
	}
	return answers
}

// planted is the segment tree: the leaf of beam i is len(dirs) + i, and the nodes above a node are its halves.
func planted(shapes []shape, dirs []IntPt) [][]*shape {
	angles := make([]float64, len(dirs))
	for i, D := range dirs {
		angles[i] = math.Atan2(float64(D.Y), float64(D.X))
	}
	sort.Slice(shapes, func(a, b int) bool { return shapes[a].least < shapes[b].least })
	tree := make([][]*shape, 2*len(dirs))
	for i := range shapes {
		s := &shapes[i]
		middle := math.Atan2(s.y, s.x)
		half := math.Asin(math.Min(1, s.r/(s.least+s.r))) + room
		for _, turn := range []float64{-2 * math.Pi, 0, 2 * math.Pi} {
			first := sort.SearchFloat64s(angles, middle+turn-half) + len(dirs)
			after := sort.SearchFloat64s(angles, middle+turn+half) + len(dirs)
			for ; first < after; first, after = first/2, after/2 {
				if first%2 == 1 {
					tree[first] = append(tree[first], s)
					first++
				}
				if after%2 == 1 {
					after--
					tree[after] = append(tree[after], s)
				}
			}
		}
	}
	return tree
}

// met says how far along the unit vector u the circle is met first.
func (s *shape) met(ux, uy, near float64) (float64, bool) {
	d, middle := math.Abs(ux*s.y-uy*s.x), ux*s.x+uy*s.y
	if d > s.r+near || middle < 0 {
		return 0, false
	}
	if d >= s.r-near {
		return middle, true
	}
	return middle - math.Sqrt((s.r-d)*(s.r+d)), true
}
