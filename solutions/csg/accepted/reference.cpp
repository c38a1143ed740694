// Pieces of the ray.
//
// The ends of all discs cut the ray into pieces, and a piece is inside a disc or outside it as a whole: so its middle
// is asked for, and the program is run with true and false on a stack. Ends that are nearly one are made one before.

#include <algorithm>
#include <cmath>
#include <vector>

struct Circle { double x, y, r; };
struct Pt { double x, y; };
struct PairRealReal { double first, second; };

static bool is_inside(const std::vector<PairRealReal>& discs, const std::vector<long long>& program, double way) {
    std::vector<bool> stack;
    for (long long step : program) {
        if (step >= 0) {
            stack.push_back(discs[step].first < way && way < discs[step].second);
            continue;
        }
        bool upper = stack.back();
        stack.pop_back();
        bool lower = stack.back();
        stack.back() = step == -1 ? lower || upper : step == -2 ? lower && upper : lower && !upper;
    }
    return stack.back();
}

std::vector<PairRealReal> inside_spans(std::vector<Circle> circles, Pt O, Pt D, std::vector<long long> program) {
    double size = 0;
    for (const Circle& c : circles) size = std::max({size, c.r, std::abs(c.x - O.x), std::abs(c.y - O.y)});
    double near = 1e-10 * size;
    double length = std::hypot(D.x, D.y), ux = D.x / length, uy = D.y / length;

    std::vector<PairRealReal> discs;
    std::vector<double> ends = {0};
    for (auto [x, y, r] : circles) {
        double fx = O.x - x, fy = O.y - y, d = std::abs(ux * fy - uy * fx);
        double foot = -(fx * ux + fy * uy), half = d < r - near ? std::sqrt((r - d) * (r + d)) : 0;
        PairRealReal span = {0, 0};
        if (half > 0) span = {std::max(0.0, foot - half), std::max(0.0, foot + half)};
        discs.push_back(span);
        ends.insert(ends.end(), {span.first, span.second});
    }
    std::sort(ends.begin(), ends.end());
    std::vector<double> cuts;
    for (double end : ends)
        if (cuts.empty() || end - cuts.back() > near) cuts.push_back(end);

    std::vector<PairRealReal> spans;
    bool goes_on = false;
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
        bool inside = is_inside(discs, program, (cuts[i] + cuts[i + 1]) / 2);
        if (inside && goes_on)
            spans.back().second = cuts[i + 1] / length;
        else if (inside)
            spans.push_back({cuts[i] / length, cuts[i + 1] / length});
        goes_on = inside;
    }
    return spans;
}
