#pragma once
// Who may use the processor for long: what the learner waits for goes before what is built ahead.

#include <companion/model/course.hpp>
#include <companion/system/file_lock.hpp>
#include <functional>
#include <optional>

namespace companion {

// While one of these exists, nothing is built ahead. To take the turn may mean to wait for the step
// that is being built ahead, which a terminal then shows.
class Turn {
  public:
    explicit Turn(const Course& course);

  private:
    FileLock lock_;
};

// A step of building ahead. It begins when nobody else has a turn, or not at all if `is_over` says
// so before.
class StepAhead {
  public:
    // `what` is built, in words for those who have to wait: "the test cases of 03.2".
    StepAhead(const Course& course, const std::string& what, const std::function<bool()>& is_over);

    bool has_begun() const { return lock_.has_value(); }

    // Whether somebody waits for the turn.
    bool is_wanted() const;

  private:
    fs::path wanted_;
    std::optional<FileLock> lock_;
};

// The file that says what is being built ahead. When it is removed, building ahead ends.
fs::path ahead_file(const Course& course);

}  // namespace companion
