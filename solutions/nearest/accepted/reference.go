// A tree of boxes.
//
// Every box holds half of its parent's circles, cut across its longer side, down to four of them. A ray leaves out each
// box that it misses or that begins beyond its best hit so far; of two halves it asks the one that it enters first.

package main

import (
	"math"
	"sort"
)

type box struct {
	x0, x1, y0, y1 float64
	circles        []int // of a leaf
	one, other     *box
}

type ray struct {
	ox, oy, ux, uy, near float64
}

func nearestHits(circles []IntCircle, rays []PairIntPtIntPt) []*PairIntReal {
	all := make([]int, len(circles))
	left, right, low, high, most := math.Inf(1), math.Inf(-1), math.Inf(1), math.Inf(-1), 0.0
	for i, c := range circles {
		all[i] = i
		left, right = math.Min(left, float64(c.X)), math.Max(right, float64(c.X))
		low, high = math.Min(low, float64(c.Y)), math.Max(high, float64(c.Y))
		most = math.Max(most, float64(c.R))
	}
	root := build(circles, all)
	answers := make([]*PairIntReal, len(rays))
	for i, each := range rays {
		ox, oy := float64(each.First.X), float64(each.First.Y)
		dx, dy := float64(each.Second.X), float64(each.Second.Y)
		length := math.Hypot(dx, dy)
		size := math.Max(math.Max(right-ox, ox-left), math.Max(high-oy, oy-low))
		r := ray{ox, oy, dx / length, dy / length, 1e-10 * math.Max(most, size)}
		best, found := math.Inf(1), -1
		r.visit(circles, root, r.enters(root), &best, &found)
		if found >= 0 {
			if best <= r.near {
				best = 0
			}
			answers[i] = &PairIntReal{First: found, Second: best / length}
		}
	}
	return answers
}

func build(circles []IntCircle, indices []int) *box {
	b := &box{x0: math.Inf(1), x1: math.Inf(-1), y0: math.Inf(1), y1: math.Inf(-1)}
	for _, i := range indices {
		x, y, r := float64(circles[i].X), float64(circles[i].Y), float64(circles[i].R)
		b.x0, b.x1 = math.Min(b.x0, x-r), math.Max(b.x1, x+r)
		b.y0, b.y1 = math.Min(b.y0, y-r), math.Max(b.y1, y+r)
	}
	if len(indices) <= 4 {
		b.circles = indices
		return b
	}
	across := b.x1-b.x0 >= b.y1-b.y0
	sort.Slice(indices, func(i, j int) bool {
		one, other := circles[indices[i]], circles[indices[j]]
		if across {
			return one.X < other.X
		}
		return one.Y < other.Y
	})
	half := len(indices) / 2
	b.one, b.other = build(circles, indices[:half]), build(circles, indices[half:])
	return b
}

// enters is where the ray's way through the box begins, infinity where it misses it.
func (r *ray) enters(b *box) float64 {
	startX, endX := slab(r.ox, r.ux, b.x0-r.near, b.x1+r.near)
	startY, endY := slab(r.oy, r.uy, b.y0-r.near, b.y1+r.near)
	start := math.Max(0, math.Max(startX, startY))
	if start > math.Min(endX, endY) {
		return math.Inf(1)
	}
	return start
}

// slab is from where to where o + s·u lies between two borders.
func slab(o, u, least, most float64) (float64, float64) {
	if u == 0 {
		if o < least || o > most {
			return math.Inf(1), math.Inf(-1)
		}
		return math.Inf(-1), math.Inf(1)
	}
	a, b := (least-o)/u, (most-o)/u
	return math.Min(a, b), math.Max(a, b)
}

func (r *ray) visit(circles []IntCircle, b *box, start float64, best *float64, found *int) {
	if math.IsInf(start, 1) || start > *best {
		return
	}
	if b.one != nil {
		one, other := r.enters(b.one), r.enters(b.other)
		if one <= other {
			r.visit(circles, b.one, one, best, found)
			r.visit(circles, b.other, other, best, found)
		} else {
			r.visit(circles, b.other, other, best, found)
			r.visit(circles, b.one, one, best, found)
		}
		return
	}
	for _, i := range b.circles {
		fx, fy, radius := float64(circles[i].X)-r.ox, float64(circles[i].Y)-r.oy, float64(circles[i].R)
		d := math.Abs(r.ux*fy - r.uy*fx)
		if d > radius+r.near {
			continue
		}
		foot, half := r.ux*fx+r.uy*fy, 0.0
		if d < radius-r.near {
			half = math.Sqrt((radius - d) * (radius + d))
		}
		way := foot - half
		if way < -r.near {
			way = foot + half
		}
		if way >= -r.near && way < *best {
			*best, *found = way, i
		}
	}
}
