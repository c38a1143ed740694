// loop
//
// What would be left is worked out first.

#include <map>
#include <string>
#include <vector>

struct PairTextInt { std::string first; long long second; };

std::map<std::string, long long> inventory(std::map<std::string, long long> stock, const std::vector<PairTextInt>& moves) {
    for (const auto& [thing, count] : moves) {
        long long left = stock.count(thing) ? stock[thing] : 0;
        if (left + count > 0) stock[thing] = left + count;
        else if (left + count == 0) stock.erase(thing);
    }
    return stock;
}
