// A grid of square cells.
//
// Every circle is entered in the cells that its box covers. A ray walks from cell to cell and asks only the
// circles there; it may stop as soon as its best hit is not beyond the border of the cell, for everything
// nearer has been seen.
import java.util.ArrayList;
import java.util.List;

class Solution {
    record IntPt(long x, long y) {}
    record IntCircle(long x, long y, long r) {}
    record PairIntPtIntPt(IntPt first, IntPt second) {}
    record PairIntReal(long first, double second) {}

    static List<PairIntReal> nearestHits(List<IntCircle> circles, List<PairIntPtIntPt> rays) {
        var grid = new Grid(circles);
        var answers = new ArrayList<PairIntReal>(rays.size());
        for (PairIntPtIntPt ray : rays) answers.add(grid.firstHit(ray.first(), ray.second()));
        return answers;
    }

    static final double INFINITY = Double.POSITIVE_INFINITY;

    static final class Grid {
        final IntCircle[] circles;
        final double left, low, right, high, largest;   // the box of all circles, the largest radius
        final double side;   // of a cell
        final int columns, rows;
        final int[] first, entries;   // cell i holds entries[first[i]] … entries[first[i + 1] - 1]

        Grid(List<IntCircle> given) {
            circles = given.toArray(new IntCircle[0]);
            double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY, most = 0;
            for (IntCircle c : circles) {
                x0 = Math.min(x0, c.x() - c.r());
                x1 = Math.max(x1, c.x() + c.r());
                y0 = Math.min(y0, c.y() - c.r());
                y1 = Math.max(y1, c.y() + c.r());
                most = Math.max(most, c.r());
            }
            left = x0;
            right = x1;
            low = y0;
            high = y1;
            largest = most;
            double wide = right - left, tall = high - low;
            side = Math.max(1.5 * Math.sqrt(wide * tall / circles.length), Math.max(wide, tall) / 1000);
            columns = (int) (wide / side) + 1;
            rows = (int) (tall / side) + 1;

            first = new int[columns * rows + 1];
            for (IntCircle c : circles) {
                for (int row = row(c.y() - c.r()); row <= row(c.y() + c.r()); row++) {
                    for (int column = column(c.x() - c.r()); column <= column(c.x() + c.r()); column++) {
                        first[row * columns + column]++;
                    }
                }
            }
            for (int cell = 0, sum = 0; cell < first.length; cell++) first[cell] = sum += first[cell];
            entries = new int[first[columns * rows]];
            for (int i = 0; i < circles.length; i++) {
                IntCircle c = circles[i];
                for (int row = row(c.y() - c.r()); row <= row(c.y() + c.r()); row++) {
                    for (int column = column(c.x() - c.r()); column <= column(c.x() + c.r()); column++) {
                        entries[--first[row * columns + column]] = i;
                    }
                }
            }
        }

        int column(double x) { return Math.max(0, Math.min(columns - 1, (int) ((x - left) / side))); }
        int row(double y) { return Math.max(0, Math.min(rows - 1, (int) ((y - low) / side))); }

        PairIntReal firstHit(IntPt O, IntPt D) {
            double ox = O.x(), oy = O.y(), length = Math.hypot(D.x(), D.y());
            double ux = D.x() / length, uy = D.y() / length;
            double ahead = Math.max(right - ox, high - oy), behind = Math.max(ox - left, oy - low);
            double near = 1e-10 * Math.max(largest, Math.max(ahead, behind));
            // Where the ray is within the grid, and where it leaves the cell; all in lengths.
            double inX = until(ox, ux, ux > 0 ? left : right), inY = until(oy, uy, uy > 0 ? low : high);
            double enter = Math.max(0, Math.max(inX, inY));
            if (outside(ox, ux, left, right) || outside(oy, uy, low, high)) return null;
            int column = column(ox + enter * ux), row = row(oy + enter * uy);

            double best = INFINITY;
            int found = -1;
            while (0 <= column && column < columns && 0 <= row && row < rows) {
                int cell = row * columns + column;
                for (int at = first[cell]; at < first[cell + 1]; at++) {
                    double way = wayTo(circles[entries[at]], ox, oy, ux, uy, near);
                    if (way < best) {
                        best = way;
                        found = entries[at];
                    }
                }
                double borderX = left + (ux > 0 ? column + 1 : column) * side;
                double borderY = low + (uy > 0 ? row + 1 : row) * side;
                double toColumn = ux == 0 ? INFINITY : (borderX - ox) / ux;
                double toRow = uy == 0 ? INFINITY : (borderY - oy) / uy;
                if (best < Math.min(toColumn, toRow) - 2 * near) break;
                if (toColumn < toRow) column += ux > 0 ? 1 : -1;
                else row += uy > 0 ? 1 : -1;
            }
            return found < 0 ? null : new PairIntReal(found, best > near ? best / length : 0);
        }

        static double until(double o, double u, double border) {
            return u == 0 ? 0 : (border - o) / u;
        }

        static boolean outside(double o, double u, double least, double most) {
            return o < least && u <= 0 || o > most && u >= 0;
        }

        /** The length from the origin to the circle's first point that is not behind; infinity for none. */
        static double wayTo(IntCircle c, double ox, double oy, double ux, double uy, double near) {
            double fx = c.x() - ox, fy = c.y() - oy, r = c.r();
            double d = Math.abs(ux * fy - uy * fx);
            if (d > r + near) return INFINITY;
            double foot = ux * fx + uy * fy, half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
            if (foot - half >= -near) return foot - half;
            return foot + half >= -near ? foot + half : INFINITY;
        }
    }
}
