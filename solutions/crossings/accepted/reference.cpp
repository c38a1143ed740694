// The cross product against the radius, squared.
//
// The line's distance from C is |k| / |D|, where k is the cross product of D = B - A and C - A. Squared and
// multiplied by |D|² it is compared with r² in whole numbers: nothing is divided, and no root is taken.

struct IntPt { long long x, y; };

long long crossings(long long cx, long long cy, long long r, IntPt A, IntPt B) {
    long long dx = B.x - A.x, dy = B.y - A.y;
    long long k = dx * (cy - A.y) - dy * (cx - A.x);
    long long away = k * k, reach = r * r * (dx * dx + dy * dy);
    return away > reach ? 0 : away == reach ? 1 : 2;
}
