#pragma once
// Building ahead, while the learner reads and writes: what all checks need, then for some exercises
// their test cases, the solution that these are linked with, and what fails in the known mistakes.
// So the first check need only compile the answer, and a wrong answer is recognized at once.

#include <companion/model/exercise.hpp>
#include <functional>
#include <vector>

namespace companion {

// Two exercises that do not pass yet: the next on the route, after the exercise with this ID, and
// the one that follows.
std::vector<Exercise> next_exercises(const Course& course, const std::string& after = "");

// Builds for these exercises what is not built yet, and waits for another process that does so.
// Tells each step before it begins. Throws app::Failure if something cannot be built.
void prepare(const Course& course, const std::vector<Exercise>& some,
             const std::function<void(const std::string& what)>& tell);

// On a terminal, does the same in the background, until the terminal closes. Nothing happens if
// all is there, or was tried in vain, or if such a process runs already. False where nothing can be
// done in the background.
bool prepare_in_background(const Course& course, const std::vector<Exercise>& some);

// Ends the process in the background, if there is one.
void end_preparing(const Course& course);

}  // namespace companion
