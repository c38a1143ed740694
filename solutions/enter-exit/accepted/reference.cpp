// Collect all hits, then sort.
//
// Each circle gives an entry and an exit, a touch, or nothing, and the tag goes with the way along the ray before
// anything is sorted. The sort keeps the order of circles that are hit at the same place.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

struct Circle { double x, y, r; };
struct Pt { double x, y; };
struct TripleRealIntWord { double first; long long second; std::string third; };

std::vector<TripleRealIntWord> all_hits(std::vector<Circle> circles, Pt O, Pt D) {
    double size = 0;
    for (const Circle& c : circles) size = std::max({size, c.r, std::abs(c.x - O.x), std::abs(c.y - O.y)});
    double near = 1e-10 * size;
    double length = std::hypot(D.x, D.y), ux = D.x / length, uy = D.y / length;
    std::vector<TripleRealIntWord> hits;
    for (size_t i = 0; i < circles.size(); ++i) {
        auto [x, y, r] = circles[i];
        double fx = O.x - x, fy = O.y - y;
        double d = std::abs(ux * fy - uy * fx), foot = -(fx * ux + fy * uy);
        auto add = [&](double way, const char* tag) {
            if (way >= -near) hits.push_back({std::max(way, 0.0) / length, (long long)i, tag});
        };
        if (d > r + near) continue;
        if (d >= r - near) {
            add(foot, "touch");
        } else {
            double half = std::sqrt((r - d) * (r + d));
            add(foot - half, "enter");
            add(foot + half, "exit");
        }
    }
    std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return hits;
}
