#pragma once
// The commands of the companion, each in a file of its own.

#include <companion/model/course.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace companion {

// What is named after the command: a chapter, an exercise; nothing means all.
using Named = std::optional<std::string>;

// Each returns the exit code.

// answer: to the first open question; without it, answers are read from the standard input.
int ask(const Course& course, const Named& chapter, const Named& answer);
// The learner's part of `book --mine`: the page to share, and the headers for the book's figures.
int book_mine(const Course& course);
// every_star: shows all open stars; otherwise only the first, if a single exercise is checked.
int check(const Course& course, const Named& chapter_or_exercise, bool every_star);
// Runs the checkpoints of one exercise under the sanitizer that is named:
// "thread", or else the others.
int check_sanitized(const Course& course, const std::string& exercise,
                    const std::string& sanitizer);
int certify(const Course& course);
int compare(const Course& course, const std::string& chapter);
int demo(const Course& course);
int hint(const Course& course, const std::string& exercise);
int list(const Course& course);
int mine(const Course& course);
int own_new(const Course& course, const std::string& folder);
// rung: 0, with no part named, means everything. seed: 0 means any.
int own_judge(const Course& course, const std::string& folder, int rung, const Named& part,
              std::uint64_t seed);
int reset(const Course& course, const std::string& exercise);
int run(const Course& course, const std::string& chapter, const std::vector<std::string>& options);
// mine: measures the learner's code where it passes, next to the solution's.
int study(const Course& course, const Named& chapter, bool mine);
// Draws docs/plots from docs/studies.
int study_of_texts(const Course& course);
int watch(const Course& course, const Named& chapter);

}  // namespace companion
