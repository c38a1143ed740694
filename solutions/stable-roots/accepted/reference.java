// Two products without error.
//
// Math.fma tells what a product has rounded off, so that b² − a·c keeps its digits, and its sign, even
// where both nearly agree. Then q = −(b ± √Δ) adds what has one sign, and the roots are q/a and c/q. Powers
// of two keep all of it in range.
import java.util.List;

class Solution {
    static List<Double> quadraticRoots(double a, double b, double c) {
        if (a == 0) {
            if (b == 0) return c == 0 ? null : List.of();
            return List.of(-c / (2 * b));
        }
        if (c == 0) return b == 0 ? List.of(0.0) : inOrder(0, -2 * b / a);

        // With t = 2^half · u the outer coefficients become about 1.
        int half = Math.floorDiv(Math.getExponent(c) - Math.getExponent(a), 2);
        int down = Math.getExponent(c), shift = half - down;
        double outer = Math.scalb(a, half + shift), last = Math.scalb(c, -down);
        boolean steep = b != 0 && Math.getExponent(b) + shift > 200;   // a·c is nothing beside b²
        if (steep) return inOrder(-2 * b / a, -c / (2 * b));
        double middle = Math.scalb(b, shift);

        double p = middle * middle, q = outer * last;
        double delta = (p - q) + (Math.fma(middle, middle, -p) - Math.fma(outer, last, -q));
        if (delta < 0) return List.of();
        if (delta == 0) return List.of(Math.scalb(-middle / outer, half));
        double sum = -(middle + Math.copySign(Math.sqrt(delta), middle));
        return inOrder(Math.scalb(sum / outer, half), Math.scalb(last / sum, half));
    }

    static List<Double> inOrder(double s, double t) {
        return List.of(Math.min(s, t), Math.max(s, t));
    }
}
