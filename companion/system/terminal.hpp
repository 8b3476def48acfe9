#pragma once
// What a terminal can do beyond printing lines.

#include <functional>
#include <string>

namespace companion {

// Prints to the standard output, without delay.
void print(const std::string& text);

// While one of these exists, what is printed is also told to `listen`.
class Overhears {
  public:
    explicit Overhears(std::function<void(const std::string&)> listen);
    ~Overhears();
    Overhears(const Overhears&) = delete;
    Overhears& operator=(const Overhears&) = delete;
};

// The text in color, if the standard output is a terminal that has colors and NO_COLOR is not set;
// otherwise the unchanged text. Color never carries information by itself.
std::string green(const std::string& text);
std::string red(const std::string& text);
std::string yellow(const std::string& text);
std::string bold(const std::string& text);
std::string dim(const std::string& text);

// A text that somebody else wrote, without what a terminal would obey: escape sequences and all
// control characters except for line end and tab. After this many bytes the text is cut off.
std::string printable(const std::string& text, std::size_t most = 4000);

// Says on a terminal what is being done, and takes that back when it ends.
class WaitingLine {
  public:
    explicit WaitingLine(const std::string& what);
    ~WaitingLine();
    WaitingLine(const WaitingLine&) = delete;
    WaitingLine& operator=(const WaitingLine&) = delete;

  private:
    bool is_shown_;
};

// Shows what a program prints, line by line, made printable and cut off if it is too long.
class Shown {
  public:
    void add(const char* bytes, std::size_t count);
    void end() const;

  private:
    std::string line_;
    std::size_t count_ = 0;
};

// "[#####.....]": how much of a whole is done.
std::string bar(int part, int whole, int width);

// The text, broken into lines of at most this many characters, each after an indent. Existing line
// breaks stay.
std::string wrapped(const std::string& text, const std::string& indent, std::size_t width = 98);

}  // namespace companion
