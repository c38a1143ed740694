// An angular sweep.
//
// Seen from O a circle covers the angles θ ± α, with sin α = r/|C - O|, and the beams go through these intervals in
// order of their angles. Of the circles whose interval has begun those with the nearest point are asked first, from a
// heap, until none can be nearer than the best hit.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>
#include <vector>

struct IntCircle { long long x, y, r; };
struct IntPt { long long x, y; };
struct PairIntReal { long long first; double second; };

struct Cover {
    double start, end;  // angles
    double least;       // the way to the circle's nearest point
    double x, y, r;     // as seen from O
    int index;
};

std::vector<std::optional<PairIntReal>> scan(std::vector<IntCircle> circles, IntPt O, std::vector<IntPt> dirs) {
    const double room = 1e-6, pi = std::numbers::pi;  // room in radians: an interval only chooses whom to ask
    double largest = 0;
    std::vector<Cover> covers;
    for (size_t i = 0; i < circles.size(); ++i) {
        double x = circles[i].x - O.x, y = circles[i].y - O.y, r = circles[i].r;
        largest = std::max({largest, r, std::abs(x), std::abs(y)});
        double away = std::hypot(x, y), middle = std::atan2(y, x), half = std::asin(std::min(1.0, r / away)) + room;
        for (double turn : {-2 * pi, 0.0, 2 * pi}) {
            Cover cover = {middle + turn - half, middle + turn + half, away - r, x, y, r, int(i)};
            if (cover.end >= -pi && cover.start <= pi) covers.push_back(cover);
        }
    }
    std::sort(covers.begin(), covers.end(), [](const Cover& a, const Cover& b) { return a.start < b.start; });
    double near = 1e-10 * largest;

    auto farther = [](const Cover& a, const Cover& b) { return a.least > b.least; };
    std::priority_queue<Cover, std::vector<Cover>, decltype(farther)> begun(farther);
    auto next = covers.begin();
    std::vector<std::optional<PairIntReal>> answers;
    std::vector<Cover> asked;
    for (IntPt D : dirs) {
        double angle = std::atan2(D.y, D.x), length = std::hypot(D.x, D.y), ux = D.x / length, uy = D.y / length;
        while (next != covers.end() && next->start <= angle) begun.push(*next++);
        double best = INFINITY;
        int found = -1;
        while (!begun.empty() && begun.top().least <= best) {
            Cover c = begun.top();
            begun.pop();
            if (c.end < angle) continue;
            asked.push_back(c);
            double d = std::abs(ux * c.y - uy * c.x), foot = ux * c.x + uy * c.y;
            if (d > c.r + near || foot < 0) continue;
            double way = d < c.r - near ? foot - std::sqrt((c.r - d) * (c.r + d)) : foot;
            if (way >= best) continue;
            best = way;
            found = c.index;
        }
        for (const Cover& c : asked) begun.push(c);
        asked.clear();
        if (found < 0)
            answers.push_back({});
        else
            answers.push_back(PairIntReal{found, best / length});
    }
    return answers;
}
