// A discriminant in more digits.
//
// Δ = b² - a·c keeps all its digits if both products are exact, with twice the bits of a double, and the difference is
// rounded once. Then the root of the equation that adds is taken, q = -(b ± √Δ) with the sign of b, and the other one
// from the product c/a. A big.Float never overflows, however large the squares are.

package main

import (
	"math"
	"math/big"
)

const bits = 128 // a product of two doubles has 106

func quadraticRoots(a, b, c float64) ([]float64, bool) {
	if a == 0 {
		if b == 0 {
			return nil, c != 0
		}
		return []float64{-c / b / 2}, true
	}
	A, B, C := big.NewFloat(a), big.NewFloat(b), big.NewFloat(c)
	delta := wide().Sub(wide().Mul(B, B), wide().Mul(A, C))
	switch delta.Sign() {
	case -1:
		return nil, true
	case 0:
		return []float64{-b / a}, true
	}
	q := wide().Sqrt(delta)
	if b < 0 {
		q.Neg(q)
	}
	q.Neg(q.Add(q, B))
	s, _ := wide().Quo(q, A).Float64()
	t, _ := wide().Quo(C, q).Float64()
	return []float64{math.Min(s, t), math.Max(s, t)}, true
}

func wide() *big.Float { return new(big.Float).SetPrec(bits) }
