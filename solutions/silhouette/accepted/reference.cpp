// One bit of memory.
//
// Whether a hit was shown in the frame before says which threshold counts now: r·(1 + h) to let go of a hit, r·(1 -
// h) to show one. It is passed only by more than 1e-10 of the frame's size, so that rounding never passes it.

#include <algorithm>
#include <cmath>
#include <vector>

struct Circle { double x, y, r; };
struct Pt { double x, y; };

std::vector<long long> steady_hits(std::vector<Circle> circles, Pt O, Pt D, double h) {
    double length = std::hypot(D.x, D.y), ux = D.x / length, uy = D.y / length;
    std::vector<long long> answer;
    bool shown = false;
    for (const Circle& c : circles) {
        double fx = O.x - c.x, fy = O.y - c.y;
        double d = std::abs(ux * fy - uy * fx);
        double near = 1e-10 * std::max({c.r, std::abs(fx), std::abs(fy)});
        if (answer.empty())
            shown = d < c.r;
        else
            shown = shown ? d <= c.r * (1 + h) + near : d < c.r * (1 - h) - near;
        answer.push_back(shown);
    }
    return answer;
}
