// Signs of the ends and the discriminant.
//
// Along the segment the distance from C falls up to the foot of the perpendicular and rises after it. So four signs say
// all: whether A is inside, whether B is, whether the line meets the circle, and whether the foot is on the segment.
// They are signs of integers, exact at any size.

package main

import "math/big"

func exactSegment(cx, cy, r *big.Int, A, B IntPt) int {
	fx, fy, gx, gy := minus(A.X, cx), minus(A.Y, cy), minus(B.X, cx), minus(B.Y, cy)
	dx, dy := minus(gx, fx), minus(gy, fy)
	a, square := dot(dx, dy, dx, dy), times(r, r)
	start := dot(fx, fy, fx, fy).Cmp(square) // below 0 where A is inside
	end := dot(gx, gy, gx, gy).Cmp(square)
	if a.Sign() == 0 {
		return count(start == 0)
	}
	k := minus(times(dx, fy), times(dy, fx))
	delta := times(square, a).Cmp(times(k, k))
	// The foot is at t = -f·D / a; both ends see it ahead of them.
	between := dot(fx, fy, dx, dy).Sign() <= 0 && dot(gx, gy, dx, dy).Sign() >= 0
	switch {
	case delta < 0:
		return 0
	case delta == 0:
		return count(between)
	case start < 0 || end < 0:
		return count(start >= 0) + count(end >= 0)
	case between:
		return 2
	}
	return count(start == 0) + count(end == 0)
}

func minus(x, y *big.Int) *big.Int { return new(big.Int).Sub(x, y) }
func times(x, y *big.Int) *big.Int { return new(big.Int).Mul(x, y) }

func dot(ux, uy, vx, vy *big.Int) *big.Int {
	return new(big.Int).Add(times(ux, vx), times(uy, vy))
}

func count(holds bool) int {
	if holds {
		return 1
	}
	return 0
}
