// Half-chord, and the power of the origin.
//
// The ways along the ray to both points are the foot's, less and more half a chord. Where these would cancel, the
// smaller way is taken from their product, which is the power of O: |f|² - r². A way within 1e-10 extents of 0 is 0.

#include <math.h>
#include <stdbool.h>

typedef struct { double x, y; } Pt;

bool ray_nearest(double cx, double cy, double r, Pt O, Pt D, double *out) {
    double length = hypot(D.x, D.y);
    if (length == 0) return false;
    double ux = D.x / length, uy = D.y / length, fx = O.x - cx, fy = O.y - cy;
    double near = 1e-10 * fmax(r, fmax(fabs(fx), fabs(fy)));
    double d = fabs(D.x * fy - D.y * fx) / length;
    if (d > r + near) return false;

    double foot = -(ux * fx + uy * fy), first = foot, second = foot;
    if (d < r - near) {
        double half = sqrt((r - d) * (r + d)), power = fx * fx + fy * fy - r * r;
        if (foot >= 0) {
            second = foot + half;
            first = power / second;
        } else {
            first = foot - half;
            second = power / first;
        }
    }
    double way = first >= -near ? first : second;
    if (way < -near) return false;
    *out = way > near ? way / length : 0;
    return true;
}
