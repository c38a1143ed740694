// one_loop
//
// Each run is looked for where the one before ends.

#include <string>

std::string runs(const std::string& s) {
    std::string parts;
    for (size_t start = 0, end; start < s.size(); start = end) {
        end = s.find_first_not_of(s[start], start);
        if (end == std::string::npos) end = s.size();
        if (end - start > 1) parts += std::to_string(end - start);
        parts += s[start];
    }
    return parts;
}
