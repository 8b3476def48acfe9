#pragma once
// Why a graft fails: what the learner's main() hands over, or which known mistake does the same.

#include <companion/model/mistakes.hpp>
#include <companion/own/graft_judge.hpp>
#include <map>
#include <set>

namespace companion {

class GraftReason {
  public:
    // For a graft that is judged by this request; `source` is the text of the learner's program.
    GraftReason(const Course& course, const GraftRequest& request, const std::string& source);

    // What to say in place of a line's suggestion, or else the suggestion. To be asked about each
    // line as soon as it is judged. If the line has failed, this takes some seconds.
    std::string operator()(const JudgedLine& line);

  private:
    struct Part {
        std::string name, source;
        bool is_recorded = false;
    };

    // Compiles programs, like our answer, unless that is done already.
    void make(const std::vector<Part>& parts);
    // A program that was made; empty if it does not compile.
    const fs::path& made(const std::string& name) const { return programs_.at(name); }

    std::string record(const std::string& program, const JudgedLine& line, bool with_list) const;
    std::string what_is_handed_over(const JudgedLine& line);
    std::string known_mistakes(const JudgedLine& line);
    std::string what_is_left(const JudgedLine& line);
    JudgedLine judged(const fs::path& program, const fs::path& reference,
                      const JudgedLine& line) const;

    const Course& course_;
    GraftRequest request_;
    std::string source_;
    std::map<std::string, fs::path> programs_{};
    std::vector<std::string> passed_{};  // lines
    std::set<std::string> said_{};
    bool is_grafted_ = true;  // no header is missing
    bool is_right_ = false;   // the last records were the same, to their end
};

}  // namespace companion
