// stretches
//
// The same stretches.
#include <algorithm>
#include <optional>
#include <vector>

std::optional<long long> hops(const std::vector<long long>& reach) {
    long long count = 0, here = 0, far = 0;
    for (long long at = 0; at < static_cast<long long>(reach.size()); ++at) {
        if (at > far) return std::nullopt;
        if (at > here) ++count, here = far;
        far = std::max(far, at + reach[at]);
    }
    return count;
}
