// stretches
//
// The same stretches.
class Solution {
    static Long hops(long[] reach) {
        long count = 0, here = 0, far = 0, at = 0;
        for (long each : reach) {
            if (at > far) return null;
            if (at > here) {
                count++;
                here = far;
            }
            far = Math.max(far, at++ + each);
        }
        return count;
    }
}
