// loop
//
// `merge` adds, and takes a thing out where its function returns null.

import java.util.List;
import java.util.Map;

class Solution {
    record PairTextInt(String first, long second) {}
    static Map<String, Long> inventory(Map<String, Long> stock, List<PairTextInt> moves) {
        for (var move : moves) {
            long left = stock.getOrDefault(move.first(), 0L) + move.second();
            if (left == 0) stock.remove(move.first());
            else if (left > 0) stock.put(move.first(), left);
        }
        return stock;
    }
}
