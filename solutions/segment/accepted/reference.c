// Foot and half-chord, cut at the ends.
//
// Along the line both points are half a chord before and after the foot of the perpendicular, in lengths from A:
// those from 0 to |B - A| are on the segment. Touching and the ends are lengths as well, and both are compared within
// 1e-10 extents.

#include <math.h>

typedef struct { double x, y; } Pt;

int circle_segment(double cx, double cy, double r, Pt A, Pt B, Pt out[2]) {
    double fx = A.x - cx, fy = A.y - cy, dx = B.x - A.x, dy = B.y - A.y;
    double size = fmax(r, fmax(fmax(fabs(fx), fabs(fy)), fmax(fabs(B.x - cx), fabs(B.y - cy))));
    double near = 1e-10 * size;
    double length = hypot(dx, dy);
    if (length == 0) {
        out[0] = A;
        return fabs(hypot(fx, fy) - r) <= near ? 1 : 0;
    }
    double ux = dx / length, uy = dy / length;
    double side = ux * fy - uy * fx, foot = -(ux * fx + uy * fy);
    double gap = r - fabs(side);
    if (gap < -near) return 0;

    double half = gap > near ? sqrt(gap * (r + fabs(side))) : 0;
    double steps[2] = {-half, half};
    int count = 0;
    for (int i = 0; i < (half > 0 ? 2 : 1); i++) {
        double step = steps[i];
        if (foot + step < -near || foot + step > length + near) continue;
        out[count++] = (Pt){cx - side * uy + step * ux, cy + side * ux + step * uy};
    }
    return count;
}
