#pragma once
// The known mistakes of an exercise, each made and run. From what fails in each of them, the
// companion tells which mistake an answer resembles.

#include <companion/build/build.hpp>
#include <companion/check/cases.hpp>
#include <companion/check/recognition.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/mistakes.hpp>
#include <functional>

namespace companion {

// The answer that contains a mistake.
struct MistakenAnswer {
    Mistake mistake;
    fs::path folder;    // which holds the answer
    BuildResult build;  // if it is not ok, there is no answer
};

// The answers of an exercise's known mistakes, of all or of those with a remark, compiled below
// this folder, several at a time.
std::vector<MistakenAnswer> make_mistakes(const Course& course, const Exercise& exercise,
                                          const fs::path& below, const std::string& remark = "");

// What fails when a mistake is made. The test cases up to the last that fails run twice unless they
// compute without end, and once more if the second run fails differently, as it may with threads or
// measured times. A run is stopped after `patience` seconds.
struct WhatFails {
    std::vector<TestCase> tests;  // of the first run
    Signature always = {};        // what fails every time
    bool by_chance = false;       // something else fails only in some runs
};
WhatFails what_fails(const Course& course, const MistakenAnswer& answer, double patience);

// Whether the test case that should catch a mistake runs to its end and fails by an assertion: in
// this run of all test cases, or else when it runs alone.
bool is_caught(const Course& course, const MistakenAnswer& answer,
               const std::vector<TestCase>& tests);

// Finds out what fails in mistakes of an exercise, several at a time, in this order; says each as
// soon as it is known, and keeps it in the build folder until mistakes, checkpoint or solution
// change. Between two mistakes, `is_over` is asked whether to stop.
void find_signatures(const Course& course, const Exercise& exercise,
                     const std::vector<Mistake>& mistakes, double patience,
                     const std::function<void(const Mistake&, const Signature&)>& found,
                     const std::function<bool()>& is_over);

// The known mistakes of an exercise of which the build folder does not yet say what fails.
std::vector<Mistake> mistakes_without_signature(const Course& course, const Exercise& exercise);

// The test case that tells most about an answer: the one that is meant to catch the mistake in
// which the same fails. Empty if that is not known without making the mistakes.
std::string most_telling(const Course& course, const Exercise& exercise,
                         const std::vector<TestCase>& tests);

// How a mistake's name follows the names before it: "This looks like: A", "or like: B" for one with
// the same signature, "and like: C" if two mistakes were made at once.
enum class Joins { first, as_or, as_and };

// Tells which known mistakes an answer with these results of the test cases resembles. Mistakes of
// which it is not known what fails in them are made and run, the likeliest first. A mistake in
// which the same fails is told at once, while those that may look the same are still being tried.
void tell_what_it_looks_like(const Course& course, const Exercise& exercise,
                             const std::vector<TestCase>& tests,
                             const std::function<void(const Mistake&, Joins)>& tell,
                             const std::function<bool()>& is_over);

}  // namespace companion
