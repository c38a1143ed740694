// Filter and exact numbers.
//
// Δ = r²·a - k² is computed in doubles, with a bound of all its roundings: the differences are off by 2⁻⁵³ of
// themselves, so k by less than 4 units of m = |p| + |q|, and r²·a by less than 8 of itself. The bound is twice what
// follows from that. Only where |Δ| is within it the exact way is taken, in numbers with bits for every product.

package main

import (
	"math"
	"math/big"
)

func deltaSign(cx, cy, r, ax, ay, bx, by float64) int {
	dx, dy, fx, fy := bx-ax, by-ay, ax-cx, ay-cy
	p, q := dx*fy, dy*fx
	k, m := p-q, math.Abs(p)+math.Abs(q)
	reach := r * r * (dx*dx + dy*dy)
	delta := reach - k*k
	bound := 2e-15*(reach+m*math.Abs(k)) + 2e-30*m*m
	switch {
	case delta > bound:
		return 1
	case delta < -bound:
		return -1
	}
	return exactSign(cx, cy, r, ax, ay, bx, by)
}

func exactSign(cx, cy, r, ax, ay, bx, by float64) int {
	dx, dy, fx, fy := minus(bx, ax), minus(by, ay), minus(ax, cx), minus(ay, cy)
	k := exact().Sub(times(dx, fy), times(dy, fx))
	a := exact().Add(times(dx, dx), times(dy, dy))
	radius := big.NewFloat(r)
	return times(times(radius, radius), a).Cmp(times(k, k))
}

// Doubles from 1e-30 to 1e30 are multiples of 2⁻¹⁵² below 2¹⁰⁰: differences have 253 bits, and Δ four times as many.
func exact() *big.Float                { return new(big.Float).SetPrec(1100) }
func minus(x, y float64) *big.Float    { return exact().Sub(big.NewFloat(x), big.NewFloat(y)) }
func times(x, y *big.Float) *big.Float { return exact().Mul(x, y) }
