#pragma once
// The order in which the course is done: the core's exercises in the order in which they need each
// other, and the grafts, with which the learner's own program grows.

#include <companion/model/exercise.hpp>
#include <companion/model/state.hpp>

namespace companion {

// A step on the route: an exercise, or a chapter's graft if there is no exercise.
struct Step {
    std::optional<Exercise> exercise = {};
    Chapter chapter = {};

    std::string id() const { return exercise ? exercise->id : "graft " + chapter.number(); }
};

// The steps in the order of course.json; if it has no route, chapter by chapter.
std::vector<Step> route(const Course& course);

// The exercises among the steps.
std::vector<Exercise> exercises_on_route(const Course& course);

bool is_open(const Course& course, const State& state, const Step& step);

// The first open step of a chapter, in the order of the route; none if all are done.
std::optional<Step> next_in_chapter(const Course& course, const Chapter& chapter);

// After an exercise of an elective, the next open one of that chapter. Otherwise an exercise that
// fails and comes before the step with this ID; or else the first open step after that one; or else
// the first open step of all. None if all is done.
std::optional<Step> next_on_route(const Course& course, const std::string& after = "");

}  // namespace companion
