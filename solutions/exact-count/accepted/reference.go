// Sign of r²·a - k².
//
// The distance of the line from C is |k| / √a, with the cross product k and a = |B - A|². It is compared with r after
// both were squared and multiplied by a: one subtraction of integers, exact at any size, and its sign is the answer.

package main

import "math/big"

func exactCount(cx, cy, r *big.Int, A, B IntPt) (int, bool) {
	dx, dy := minus(B.X, A.X), minus(B.Y, A.Y)
	if dx.Sign() == 0 && dy.Sign() == 0 {
		return 0, false
	}
	k := minus(times(dx, minus(A.Y, cy)), times(dy, minus(A.X, cx)))
	a := new(big.Int).Add(times(dx, dx), times(dy, dy))
	delta := minus(times(times(r, r), a), times(k, k))
	return 1 + delta.Sign(), true
}

func minus(x, y *big.Int) *big.Int { return new(big.Int).Sub(x, y) }
func times(x, y *big.Int) *big.Int { return new(big.Int).Mul(x, y) }
