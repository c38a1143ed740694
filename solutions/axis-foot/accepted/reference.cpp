// Coordinates put together.
//
// On a level line the foot has P's x and the line's y, and on an upright line it is the other way round. So nothing
// has to be computed.

struct IntPt { long long x, y; };

IntPt axis_foot(IntPt A, IntPt B, IntPt P) {
    bool level = A.y == B.y;
    return level ? IntPt{P.x, A.y} : IntPt{A.x, P.y};
}
