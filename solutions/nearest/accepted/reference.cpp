// A tree of boxes.
//
// Each box holds half of its parent's circles, by the longer side, down to four. A ray leaves out each box that it
// misses or that begins beyond the best hit so far, with all that is in it; of two boxes it asks the nearer one first.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

struct IntCircle { long long x, y, r; };
struct IntPt { long long x, y; };
struct PairIntPtIntPt { IntPt first, second; };
struct PairIntReal { long long first; double second; };

struct Box {
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    int begin, end, one = -1, other = -1;  // its circles in `order`; its two halves, or none
};

struct Tree {
    const std::vector<IntCircle>& circles;
    std::vector<int> order;
    std::vector<Box> boxes;
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY, largest = 0;

    explicit Tree(const std::vector<IntCircle>& all) : circles(all), order(all.size()) {
        std::iota(order.begin(), order.end(), 0);
        for (auto [x, y, r] : circles) {
            left = std::min(left, double(x)), right = std::max(right, double(x));
            low = std::min(low, double(y)), high = std::max(high, double(y));
            largest = std::max(largest, double(r));
        }
        build(0, int(order.size()));
    }

    int build(int begin, int end) {
        Box box{.begin = begin, .end = end};
        for (int at = begin; at < end; ++at) {
            auto [x, y, r] = circles[order[at]];
            box.x0 = std::min(box.x0, double(x - r)), box.x1 = std::max(box.x1, double(x + r));
            box.y0 = std::min(box.y0, double(y - r)), box.y1 = std::max(box.y1, double(y + r));
        }
        int number = int(boxes.size());
        boxes.push_back(box);
        if (end - begin > 4) {
            bool across = box.x1 - box.x0 >= box.y1 - box.y0;
            int middle = (begin + end) / 2;
            std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, [&](int i, int j) {
                return across ? circles[i].x < circles[j].x : circles[i].y < circles[j].y;
            });
            int one = build(begin, middle), other = build(middle, end);
            boxes[number].one = one, boxes[number].other = other;
        }
        return number;
    }

    std::optional<PairIntReal> first_hit(IntPt O, IntPt D) const {
        double ox = O.x, oy = O.y, length = std::hypot(double(D.x), double(D.y));
        double ux = D.x / length, uy = D.y / length;
        double near = 1e-10 * std::max({largest, ox - left, right - ox, oy - low, high - oy});
        // Where the ray enters a box, in lengths; infinity where it misses it.
        auto enters = [&](const Box& box) {
            double start = 0, end = INFINITY;
            auto clip = [&](double o, double u, double least, double most) {
                if (u == 0) {
                    if (o < least - near || o > most + near) end = -1;
                    return;
                }
                double a = (least - near - o) / u, b = (most + near - o) / u;
                start = std::max(start, std::min(a, b));
                end = std::min(end, std::max(a, b));
            };
            clip(ox, ux, box.x0, box.x1);
            clip(oy, uy, box.y0, box.y1);
            return start <= end ? start : INFINITY;
        };
        double best = INFINITY;
        int found = -1;
        std::vector<std::pair<double, int>> stack{{enters(boxes[0]), 0}};
        while (!stack.empty()) {
            auto [start, number] = stack.back();
            stack.pop_back();
            if (start == INFINITY || start > best) continue;
            const Box& box = boxes[number];
            if (box.one >= 0) {
                std::pair one{enters(boxes[box.one]), box.one}, other{enters(boxes[box.other]), box.other};
                if (one.first < other.first) std::swap(one, other);
                stack.push_back(one);
                stack.push_back(other);
                continue;
            }
            for (int at = box.begin; at < box.end; ++at) {
                int i = order[at];
                double fx = circles[i].x - ox, fy = circles[i].y - oy, r = circles[i].r;
                double d = std::abs(ux * fy - uy * fx);
                if (d > r + near) continue;
                double foot = ux * fx + uy * fy;
                double half = d < r - near ? std::sqrt((r - d) * (r + d)) : 0;
                double way = foot - half < -near ? foot + half : foot - half;
                if (way < -near || way >= best) continue;
                best = way;
                found = i;
            }
        }
        if (found < 0) return {};
        return PairIntReal{found, best > near ? best / length : 0};
    }
};

std::vector<std::optional<PairIntReal>> nearest_hits(std::vector<IntCircle> circles,
                                                      std::vector<PairIntPtIntPt> rays) {
    Tree tree(circles);
    std::vector<std::optional<PairIntReal>> answers;
    for (const auto& [O, D] : rays) answers.push_back(tree.first_hit(O, D));
    return answers;
}
