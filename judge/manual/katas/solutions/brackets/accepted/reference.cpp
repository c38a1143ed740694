// stack
//
// What is open lies on a stack, and a closing bracket takes the last one.

#include <string>

bool balanced(const std::string& s) {
    std::string opened;
    for (char sign : s) {
        if (sign == '(') opened += ')';
        else if (sign == '[') opened += ']';
        else if (sign == '{') opened += '}';
        else if (opened.empty() || opened.back() != sign) return false;
        else opened.pop_back();
    }
    return opened.empty();
}
