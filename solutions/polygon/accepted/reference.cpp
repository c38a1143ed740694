// Half-open edges.
//
// Each edge has its first corner and leaves its last one to the next edge, so that a corner is met once. Ways along
// an edge are lengths from its first corner: those from -near up to the edge's length - near count, the nearer one
// first.

#include <algorithm>
#include <cmath>
#include <vector>

struct Pt { double x, y; };
struct PairIntPt { long long first; Pt second; };

std::vector<PairIntPt> boundary_hits(double cx, double cy, double r, std::vector<Pt> V) {
    double size = r;
    for (Pt p : V) size = std::max({size, std::abs(p.x - cx), std::abs(p.y - cy)});
    double near = 1e-10 * size;
    std::vector<PairIntPt> found;
    for (size_t i = 0; i < V.size(); ++i) {
        Pt A = V[i], B = V[(i + 1) % V.size()];
        double fx = A.x - cx, fy = A.y - cy, dx = (B.x - cx) - fx, dy = (B.y - cy) - fy;
        double length = std::hypot(dx, dy), ux = dx / length, uy = dy / length;
        double d = std::abs(ux * fy - uy * fx);
        if (d > r + near) continue;
        auto add = [&](double way) {
            if (way < -near || way >= length - near) return;
            found.push_back({(long long)i, {A.x + way * ux, A.y + way * uy}});
        };
        double foot = -(fx * ux + fy * uy);
        if (d < r - near) {
            double half = std::sqrt((r - d) * (r + d));
            add(foot - half);
            add(foot + half);
        } else {
            add(foot);
        }
    }
    return found;
}
