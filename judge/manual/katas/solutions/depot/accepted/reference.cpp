// List of numbers.
//
// A number for each shelf, and a word at a time.
#include <iostream>
#include <string>
#include <vector>

int main() {
    int shelves, count, shelf;
    std::string word, skip;
    std::cin >> shelves >> skip;
    std::vector<int> boxes(shelves + 1);
    while (std::cin >> word && word != "end") {
        if (word == "how") {
            std::cin >> skip >> skip >> skip >> shelf;
            std::cout << boxes[shelf] << '\n';
            continue;
        }
        std::cin >> count >> skip >> skip >> shelf;
        if (word == "put")
            boxes[shelf] += count;
        else if (boxes[shelf] < count)
            std::cout << "refused\n";
        else
            std::cout << (boxes[shelf] -= count) << '\n';
    }
}
