#pragma once
// What a terminal can do beyond printing lines.

#include <string>

namespace companion {

// Prints to the standard output, at once.
void print(const std::string& text);

// Colors, if the standard output is a terminal that has them and NO_COLOR is not set; otherwise the
// text as it is. Nothing is said by color alone.
std::string green(const std::string& text);
std::string red(const std::string& text);
std::string yellow(const std::string& text);
std::string bold(const std::string& text);
std::string dim(const std::string& text);

// A text that somebody else wrote, without what a terminal would obey: escape sequences and control
// characters other than the line's end and the tab. Of more than this many bytes the rest is cut.
std::string printable(const std::string& text, std::size_t most = 4000);

// Shows what a program prints, line by line, as far as it is printable and not too much.
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

// The text in lines of at most this many characters, each after an indent. Its own line ends stay.
std::string wrapped(const std::string& text, const std::string& indent, std::size_t width = 98);

}  // namespace companion
