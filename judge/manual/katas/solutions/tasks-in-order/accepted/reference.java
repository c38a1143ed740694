// free first
//
// The same count of what is missing.
import java.util.ArrayList;
import java.util.List;

class Solution {
    static List<Long> tasksInOrder(long count, List<PairIntInt> needs) {
        int[] missing = new int[(int) count];
        for (PairIntInt need : needs) missing[(int) need.second()]++;
        List<Long> order = new ArrayList<>();
        for (int task = 0; task < count; task++) if (missing[task] == 0) order.add((long) task);
        for (int at = 0; at < order.size(); at++)
            for (PairIntInt need : needs)
                if (need.first() == order.get(at) && --missing[(int) need.second()] == 0) order.add(need.second());
        return order.size() == count ? order : null;
    }
}
