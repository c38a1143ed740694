// Two rays and a least way.
//
// The first ray takes the least way ahead to a circle, and the sign of D·N says which side of it is seen. From there
// a second ray goes to the light: any circle between 1e-9 of the size, so that the point does not shade itself, and
// the light makes it dark.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

struct Circle { double x, y, r; };
struct Pt { double x, y; };

// The ways along the unit vector u from `start` to the circle, in order; none where the line misses it.
static std::vector<double> ways(const Circle& c, Pt start, Pt u) {
    double fx = start.x - c.x, fy = start.y - c.y, d = std::abs(u.x * fy - u.y * fx);
    if (d >= c.r) return {};
    double foot = -(fx * u.x + fy * u.y), half = std::sqrt((c.r - d) * (c.r + d));
    return {foot - half, foot + half};
}

std::optional<std::string> light(std::vector<Circle> circles, Pt O, Pt D, Pt L) {
    double size = std::max(std::abs(L.x - O.x), std::abs(L.y - O.y));
    for (const Circle& c : circles) size = std::max({size, c.r, std::abs(c.x - O.x), std::abs(c.y - O.y)});
    double near = 1e-9 * size;

    double length = std::hypot(D.x, D.y), first = INFINITY;
    Pt u = {D.x / length, D.y / length};
    const Circle* hit = nullptr;
    for (const Circle& c : circles) {
        for (double way : ways(c, O, u)) {
            if (way <= 0 || way >= first) continue;
            first = way;
            hit = &c;
        }
    }
    if (!hit) return {};

    // From here on all is seen from the centre of that circle, so that nothing is lost far from the origin.
    Pt N = {O.x - hit->x + first * u.x, O.y - hit->y + first * u.y};
    Pt V = {L.x - hit->x - N.x, L.y - hit->y - N.y};
    bool seen_from_outside = u.x * N.x + u.y * N.y < 0, lit_from_outside = V.x * N.x + V.y * N.y > 0;
    if (seen_from_outside != lit_from_outside) return "dark";
    double reach = std::hypot(V.x, V.y);
    for (const Circle& c : circles)
        for (double way : ways({c.x - hit->x, c.y - hit->y, c.r}, N, {V.x / reach, V.y / reach}))
            if (near < way && way < reach) return "dark";
    return "lit";
}
