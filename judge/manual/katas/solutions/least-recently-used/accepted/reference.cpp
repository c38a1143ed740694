// a list in the order of use
//
// The key that was used last is the first of a list, and a map knows where each key stands in it.

#include <list>
#include <optional>
#include <unordered_map>

class LRUCache {
    long long capacity;
    std::list<std::pair<long long, long long>> pairs;
    std::unordered_map<long long, std::list<std::pair<long long, long long>>::iterator> places;

public:
    LRUCache(long long capacity) : capacity(capacity) {}

    std::optional<long long> get(long long key) {
        auto found = places.find(key);
        if (found == places.end()) return {};
        pairs.splice(pairs.begin(), pairs, found->second);
        return found->second->second;
    }

    void put(long long key, long long value) {
        if (get(key)) {
            pairs.front().second = value;
            return;
        }
        pairs.emplace_front(key, value);
        places[key] = pairs.begin();
        if ((long long)pairs.size() > capacity) {
            places.erase(pairs.back().first);
            pairs.pop_back();
        }
    }
};
