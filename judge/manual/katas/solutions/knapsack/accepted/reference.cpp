// by weight
//
// The same table.
#include <algorithm>
#include <vector>

long long knapsack(const std::vector<PairIntInt>& things, long long capacity) {
    std::vector<long long> best(capacity + 1);
    for (const auto& thing : things)
        for (long long total = capacity; total >= thing.first; --total)
            best[total] = std::max(best[total], best[total - thing.first] + thing.second);
    return best[capacity];
}
