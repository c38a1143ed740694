// by weight
//
// The same table.
import java.util.List;

class Solution {
    static long knapsack(List<PairIntInt> things, long capacity) {
        long[] best = new long[(int) capacity + 1];
        for (PairIntInt thing : things)
            for (int total = (int) capacity; total >= thing.first(); total--)
                best[total] = Math.max(best[total], best[total - (int) thing.first()] + thing.second());
        return best[(int) capacity];
    }
}
