// Addresses, a pointer, a reference; and what happens at a closing brace.
#include <iostream>

class Guest {
  public:
    Guest() { std::cout << "  hello\n"; }
    ~Guest() { std::cout << "  goodbye\n"; }
};

int main() {
    int x = 5;
    int* p = &x;
    int& r = x;
    std::cout << "x is at " << &x << ", p holds " << p << ", and there lies " << *p << '\n';
    *p = 7;
    r = r + 1;
    std::cout << "now x is " << x << '\n';
    {
        Guest guest;
        std::cout << "  inside the block\n";
    }
    std::cout << "after it\n";
}
