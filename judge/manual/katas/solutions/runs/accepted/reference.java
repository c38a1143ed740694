// one_loop
//
// Each run is looked for where the one before ends.

class Solution {
    static String runs(String s) {
        var parts = new StringBuilder();
        for (int start = 0, end = 0; start < s.length(); start = end) {
            while (end < s.length() && s.charAt(end) == s.charAt(start)) end++;
            if (end - start > 1) parts.append(end - start);
            parts.append(s.charAt(start));
        }
        return parts.toString();
    }
}
