// Coordinates.
//
// On a level line the foot has P's x and the line's y; on an upright line it is the other way round. Nothing has to be
// computed.

package main

func axisFoot(A, B, P IntPt) IntPt {
	if A.Y == B.Y {
		return IntPt{P.X, A.Y}
	}
	return IntPt{A.X, P.Y}
}
