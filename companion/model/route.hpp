#pragma once
// The order in which the course is done: exercises of the core by need, and the grafts, by which
// the learner's own program grows.

#include <companion/model/exercise.hpp>
#include <companion/model/state.hpp>

namespace companion {

// A stop on the route: an exercise, or else a chapter's graft.
struct Step {
    std::optional<Exercise> exercise = {};
    Chapter chapter = {};

    std::string id() const { return exercise ? exercise->id : "graft " + chapter.number(); }
};

// The steps in the order of course.json; without one there, chapter by chapter.
std::vector<Step> route(const Course& course);

// The exercises among the steps.
std::vector<Exercise> exercises_on_route(const Course& course);

bool is_open(const Course& course, const State& state, const Step& step);

// An exercise that fails and comes before the step with this id; else the first open step after
// that one, else the first of all. None: all is done.
std::optional<Step> next_on_route(const Course& course, const std::string& after = "");

}  // namespace companion
