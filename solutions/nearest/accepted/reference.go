// A grid of square cells.
//
// A circle is entered in every cell that it reaches. A ray visits the cells on its way in order, and asks only the
// circles in them; it stops when its best hit is not beyond the border of the cell that it stands in, for everything
// nearer has been seen.

package main

import "math"

type grid struct {
	circles       []IntCircle
	left, low     float64 // its corner
	right, high   float64
	most          float64 // the largest radius
	side          float64 // of a cell
	columns, rows int
	cells         [][]int // the circles of each cell, row by row
}

func nearestHits(circles []IntCircle, rays []PairIntPtIntPt) []*PairIntReal {
	g := build(circles)
	answers := make([]*PairIntReal, len(rays))
	for i, ray := range rays {
		answers[i] = g.first(ray.First, ray.Second)
	}
	return answers
}

func build(circles []IntCircle) *grid {
	g := &grid{circles: circles, left: math.Inf(1), low: math.Inf(1), right: math.Inf(-1), high: math.Inf(-1)}
	for _, c := range circles {
		x, y, r := float64(c.X), float64(c.Y), float64(c.R)
		g.left, g.right = math.Min(g.left, x-r), math.Max(g.right, x+r)
		g.low, g.high = math.Min(g.low, y-r), math.Max(g.high, y+r)
		g.most = math.Max(g.most, r)
	}
	wide, tall := g.right-g.left, g.high-g.low
	g.side = math.Max(math.Max(1, 1.5*math.Sqrt(wide*tall/float64(len(circles)))), math.Max(wide, tall)/1000)
	g.columns, g.rows = int(wide/g.side)+1, int(tall/g.side)+1
	g.cells = make([][]int, g.columns*g.rows)
	for i, c := range circles {
		x, y, r := float64(c.X)-g.left, float64(c.Y)-g.low, float64(c.R)
		for row := int((y - r) / g.side); row <= int((y+r)/g.side); row++ {
			for column := int((x - r) / g.side); column <= int((x+r)/g.side); column++ {
				at := row*g.columns + column
				g.cells[at] = append(g.cells[at], i)
			}
		}
	}
	return g
}

// first is the first hit of a ray. All lengths along it are those of its unit vector.
func (g *grid) first(O, D IntPt) *PairIntReal {
	ox, oy := float64(O.X), float64(O.Y)
	length := math.Hypot(float64(D.X), float64(D.Y))
	ux, uy := float64(D.X)/length, float64(D.Y)/length
	extent := math.Max(math.Max(g.right-ox, ox-g.left), math.Max(g.high-oy, oy-g.low))
	near := 1e-10 * math.Max(g.most, extent)

	startX, endX := slab(ox, ux, g.left, g.left+float64(g.columns)*g.side)
	startY, endY := slab(oy, uy, g.low, g.low+float64(g.rows)*g.side)
	start := math.Max(0, math.Max(startX, startY))
	if start > math.Min(endX, endY) {
		return nil
	}
	column, stepX, nextX, eachX := g.walk(ox, ux, g.left, start, g.columns)
	row, stepY, nextY, eachY := g.walk(oy, uy, g.low, start, g.rows)
	best, found := math.Inf(1), -1
	for 0 <= column && column < g.columns && 0 <= row && row < g.rows {
		for _, i := range g.cells[row*g.columns+column] {
			c := g.circles[i]
			if way, ok := hit(float64(c.X)-ox, float64(c.Y)-oy, float64(c.R), ux, uy, near); ok && way < best {
				best, found = way, i
			}
		}
		if best < math.Min(nextX, nextY)-2*near {
			break
		}
		if nextX < nextY {
			column, nextX = column+stepX, nextX+eachX
		} else {
			row, nextY = row+stepY, nextY+eachY
		}
	}
	if found < 0 {
		return nil
	}
	return &PairIntReal{found, best / length}
}

// hit says how far along u the circle around f is met first, if it is met ahead of the origin.
func hit(fx, fy, r, ux, uy, near float64) (float64, bool) {
	d := math.Abs(ux*fy - uy*fx)
	if d > r+near {
		return 0, false
	}
	middle, half := ux*fx+uy*fy, 0.0
	if d < r-near {
		half = math.Sqrt((r - d) * (r + d))
	}
	way := middle - half
	if way < -near {
		way = middle + half
	}
	if math.Abs(way) <= near {
		return 0, true
	}
	return way, way > 0
}

// slab says from where to where a ray is between two borders, in one coordinate.
func slab(o, u, low, high float64) (float64, float64) {
	if u == 0 && low <= o && o <= high {
		return math.Inf(-1), math.Inf(1)
	}
	if u == 0 {
		return math.Inf(1), math.Inf(-1)
	}
	a, b := (low-o)/u, (high-o)/u
	return math.Min(a, b), math.Max(a, b)
}

// walk says, in one coordinate, where the ray starts, its step, and how far the next border is, and each one after it.
func (g *grid) walk(o, u, low, start float64, count int) (cell, step int, next, each float64) {
	cell = int((o + start*u - low) / g.side)
	if cell >= count {
		cell = count - 1
	}
	switch {
	case u > 0:
		return cell, 1, (low + float64(cell+1)*g.side - o) / u, g.side / u
	case u < 0:
		return cell, -1, (low + float64(cell)*g.side - o) / u, -g.side / u
	}
	return cell, 0, math.Inf(1), math.Inf(1)
}
