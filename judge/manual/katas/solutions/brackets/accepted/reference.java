// stack
//
// What is open lies on a stack, and a closing bracket takes the last one.

class Solution {
    static boolean balanced(String s) {
        var opened = new java.util.ArrayDeque<Character>();
        for (char sign : s.toCharArray()) {
            int kind = "([{".indexOf(sign);
            if (kind >= 0) opened.push(")]}".charAt(kind));
            else if (opened.isEmpty() || opened.pop() != sign) return false;
        }
        return opened.isEmpty();
    }
}
