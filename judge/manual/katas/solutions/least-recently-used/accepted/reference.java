// a map in the order of use
//
// A LinkedHashMap may keep its keys in the order of use, and asks after each put whether the eldest one goes.

import java.util.LinkedHashMap;
import java.util.Map;

class LRUCache extends LinkedHashMap<Long, Long> {
    private final long capacity;

    LRUCache(long capacity) {
        super(16, 0.75f, true);
        this.capacity = capacity;
    }

    Long get(long key) {
        return super.get(key);
    }

    void put(long key, long value) {
        super.put(key, value);
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<Long, Long> eldest) {
        return size() > capacity;
    }
}
