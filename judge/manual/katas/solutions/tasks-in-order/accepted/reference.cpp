// free first
//
// The same count of what is missing.
#include <optional>
#include <vector>

std::optional<std::vector<long long>> tasks_in_order(long long count, const std::vector<PairIntInt>& needs) {
    std::vector<int> missing(count);
    for (const auto& need : needs) ++missing[need.second];
    std::vector<long long> order;
    for (int task = 0; task < count; ++task)
        if (!missing[task]) order.push_back(task);
    for (std::size_t at = 0; at < order.size(); ++at)
        for (const auto& need : needs)
            if (need.first == order[at] && !--missing[need.second]) order.push_back(need.second);
    if (static_cast<long long>(order.size()) != count) return std::nullopt;
    return order;
}
