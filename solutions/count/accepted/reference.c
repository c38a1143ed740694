// The distance against the radius.
//
// Seen from the centre the cross product of B - A and A - C is |B - A| times the line's distance, wherever A and B
// are on the line. The distance is compared with r within 1e-10 of the size, more than rounding and less than the
// nearest miss.

#include <math.h>
#include <stdbool.h>

typedef struct { double x, y; } Pt;

bool line_count(double cx, double cy, double r, Pt A, Pt B, long long *out) {
    double dx = B.x - A.x, dy = B.y - A.y;
    if (dx == 0 && dy == 0) return false;
    double fx = A.x - cx, fy = A.y - cy;
    double size = fmax(r, fmax(fmax(fabs(fx), fabs(fy)), fmax(fabs(B.x - cx), fabs(B.y - cy))));
    double near = 1e-10 * size;
    double gap = fabs(dx * fy - dy * fx) / hypot(dx, dy) - r;
    *out = gap > near ? 0 : gap < -near ? 2 : 1;
    return true;
}
