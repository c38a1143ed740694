// A tree of boxes.
//
// Each box holds half of its parent's circles, cut across its longer side, down to four. A ray leaves out every box that
// it misses or that begins beyond the best hit so far, and of two halves it asks the one that it enters first.
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

class Solution {
    record IntPt(long x, long y) {}
    record IntCircle(long x, long y, long r) {}
    record PairIntPtIntPt(IntPt first, IntPt second) {}
    record PairIntReal(long first, double second) {}

    static final double INFINITY = Double.POSITIVE_INFINITY;

    static List<PairIntReal> nearestHits(List<IntCircle> circles, List<PairIntPtIntPt> rays) {
        var all = new Disc[circles.size()];
        double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY, most = 0;
        for (int i = 0; i < all.length; i++) {
            IntCircle c = circles.get(i);
            all[i] = new Disc(c.x(), c.y(), c.r(), i);
            left = Math.min(left, c.x());
            right = Math.max(right, c.x());
            low = Math.min(low, c.y());
            high = Math.max(high, c.y());
            most = Math.max(most, c.r());
        }
        var root = new Box(all, 0, all.length);
        var answers = new ArrayList<PairIntReal>(rays.size());
        for (PairIntPtIntPt ray : rays) {
            double ox = ray.first().x(), oy = ray.first().y();
            double size = Math.max(Math.max(right - ox, ox - left), Math.max(high - oy, oy - low));
            answers.add(new Ray(ray, 1e-10 * Math.max(most, size)).first(root));
        }
        return answers;
    }

    record Disc(double x, double y, double r, int index) {}

    static final class Box {
        double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
        Disc[] discs;   // of a leaf
        Box one, other;

        Box(Disc[] all, int begin, int end) {
            for (int i = begin; i < end; i++) {
                Disc d = all[i];
                x0 = Math.min(x0, d.x - d.r);
                x1 = Math.max(x1, d.x + d.r);
                y0 = Math.min(y0, d.y - d.r);
                y1 = Math.max(y1, d.y + d.r);
            }
            if (end - begin <= 4) {
                discs = Arrays.copyOfRange(all, begin, end);
                return;
            }
            boolean across = x1 - x0 >= y1 - y0;
            Arrays.sort(all, begin, end, Comparator.comparingDouble(d -> across ? d.x : d.y));
            int middle = (begin + end) / 2;
            one = new Box(all, begin, middle);
            other = new Box(all, middle, end);
        }
    }

    static final class Ray {
        final double ox, oy, ux, uy, length, near;
        double best = INFINITY;
        int found = -1;

        Ray(PairIntPtIntPt ray, double near) {
            ox = ray.first().x();
            oy = ray.first().y();
            length = Math.hypot(ray.second().x(), ray.second().y());
            ux = ray.second().x() / length;
            uy = ray.second().y() / length;
            this.near = near;
        }

        PairIntReal first(Box root) {
            visit(root, enters(root));
            return found < 0 ? null : new PairIntReal(found, best > near ? best / length : 0);
        }

        /** Where the way through a box begins; infinity where it is missed. */
        double enters(Box box) {
            double start = 0, end = INFINITY;
            double[][] slabs = {{ox, ux, box.x0, box.x1}, {oy, uy, box.y0, box.y1}};
            for (double[] slab : slabs) {
                double least = slab[2] - near - slab[0], most = slab[3] + near - slab[0];
                if (slab[1] == 0) {
                    if (least > 0 || most < 0) return INFINITY;
                    continue;
                }
                double a = least / slab[1], b = most / slab[1];
                start = Math.max(start, Math.min(a, b));
                end = Math.min(end, Math.max(a, b));
            }
            return start <= end ? start : INFINITY;
        }

        void visit(Box box, double start) {
            if (start == INFINITY || start > best) return;
            if (box.discs == null) {
                double one = enters(box.one), other = enters(box.other);
                boolean first = one <= other;
                visit(first ? box.one : box.other, Math.min(one, other));
                visit(first ? box.other : box.one, Math.max(one, other));
                return;
            }
            for (Disc disc : box.discs) {
                double fx = disc.x - ox, fy = disc.y - oy, r = disc.r;
                double d = Math.abs(ux * fy - uy * fx);
                if (d > r + near) continue;
                double foot = ux * fx + uy * fy;
                double half = d < r - near ? Math.sqrt((r - d) * (r + d)) : 0;
                double way = foot - half < -near ? foot + half : foot - half;
                if (way < -near || way >= best) continue;
                best = way;
                found = disc.index;
            }
        }
    }
}
