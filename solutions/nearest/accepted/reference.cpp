// A uniform grid.
//
// Each circle is entered into the square cells that it reaches, and a ray walks from cell to cell in the order of t.
// It stops when its best hit is not beyond the border of the cell where it stands: everything nearer has been seen.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

struct IntCircle { long long x, y, r; };
struct IntPt { long long x, y; };
struct PairIntPtIntPt { IntPt first, second; };
struct PairIntReal { long long first; double second; };

struct Grid {
    const std::vector<IntCircle>& circles;
    double left = INFINITY, low = INFINITY, right = -INFINITY, high = -INFINITY, largest = 0, side = 1;
    int columns = 0, rows = 0;
    std::vector<std::vector<int>> cells;

    explicit Grid(const std::vector<IntCircle>& all) : circles(all) {
        for (auto [x, y, r] : circles) {
            left = std::min(left, double(x - r));
            right = std::max(right, double(x + r));
            low = std::min(low, double(y - r));
            high = std::max(high, double(y + r));
            largest = std::max(largest, double(r));
        }
        double wide = right - left, tall = high - low;
        side = std::max({1.0, 1.5 * std::sqrt(wide * tall / circles.size()), wide / 1000, tall / 1000});
        columns = int(wide / side) + 1;
        rows = int(tall / side) + 1;
        cells.resize(size_t(columns) * rows);
        for (size_t i = 0; i < circles.size(); ++i) {
            auto [x, y, r] = circles[i];
            for (int row = int((y - r - low) / side); row <= int((y + r - low) / side); ++row)
                for (int column = int((x - r - left) / side); column <= int((x + r - left) / side); ++column)
                    cells[size_t(row) * columns + column].push_back(int(i));
        }
    }

    std::optional<PairIntReal> first_hit(IntPt O, IntPt D) const {
        double ox = O.x, oy = O.y, dx = D.x, dy = D.y, length = std::hypot(dx, dy);
        double near = 1e-10 * std::max({largest, ox - left, right - ox, oy - low, high - oy});

        double enter = 0, leave = INFINITY;  // the ray's ways into the grid and out of it, in lengths of D
        auto clip = [&](double o, double d, double start, double end) {
            if (d == 0) {
                if (o < start || o > end) leave = -1;
                return;
            }
            auto [a, b] = std::minmax((start - o) / d, (end - o) / d);
            enter = std::max(enter, double(a));
            leave = std::min(leave, double(b));
        };
        clip(ox, dx, left, left + columns * side);
        clip(oy, dy, low, low + rows * side);
        if (enter > leave) return {};

        int column = std::clamp(int(std::floor((ox + enter * dx - left) / side)), 0, columns - 1);
        int row = std::clamp(int(std::floor((oy + enter * dy - low) / side)), 0, rows - 1);
        double next_column = dx != 0 ? (left + (column + (dx > 0)) * side - ox) / dx : INFINITY;
        double next_row = dy != 0 ? (low + (row + (dy > 0)) * side - oy) / dy : INFINITY;
        double best = INFINITY;
        int found = -1;
        while (0 <= column && column < columns && 0 <= row && row < rows) {
            for (int i : cells[size_t(row) * columns + column]) {
                double fx = circles[i].x - ox, fy = circles[i].y - oy, r = circles[i].r;
                double d = std::abs(dx * fy - dy * fx) / length;
                if (d > r + near) continue;
                double foot = (dx * fx + dy * fy) / length;
                double half = d < r - near ? std::sqrt((r - d) * (r + d)) : 0;
                double way = foot - half < -near ? foot + half : foot - half;
                if (way < -near || way >= best) continue;
                best = way > near ? way : 0;
                found = i;
            }
            if (best < std::min(next_column, next_row) * length - 2 * near) break;
            if (next_column < next_row) {
                column += dx > 0 ? 1 : -1;
                next_column += side / std::abs(dx);
            } else {
                row += dy > 0 ? 1 : -1;
                next_row += side / std::abs(dy);
            }
        }
        if (found < 0) return {};
        return PairIntReal{found, best / length};
    }
};

std::vector<std::optional<PairIntReal>> nearest_hits(std::vector<IntCircle> circles,
                                                      std::vector<PairIntPtIntPt> rays) {
    Grid grid(circles);
    std::vector<std::optional<PairIntReal>> answers;
    for (const auto& [O, D] : rays) answers.push_back(grid.first_hit(O, D));
    return answers;
}
