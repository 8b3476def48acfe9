#pragma once
// The known mistakes of an exercise, each made and run. From what fails in each of them, the
// companion tells which mistake an answer resembles.

#include <companion/build/build.hpp>
#include <companion/check/cases.hpp>
#include <companion/check/recognition.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/mistakes.hpp>

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
// measured times.
struct WhatFails {
    std::vector<TestCase> tests;  // of the first run
    Signature always = {};        // what fails every time
    bool by_chance = false;       // something else fails only in some runs
};
WhatFails what_fails(const Course& course, const MistakenAnswer& answer);

// Whether the test case that should catch a mistake runs to its end and fails by an assertion: in
// this run of all test cases, or else when it runs alone.
bool is_caught(const Course& course, const MistakenAnswer& answer,
               const std::vector<TestCase>& tests);

// What fails in each known mistake of an exercise. The first call finds this out, which takes a few
// seconds, and stores it in the build folder until mistakes, checkpoint or solution change.
Signatures signatures_of(const Course& course, const Exercise& exercise);

// The known mistake that an answer resembles, with those that have the same signature; or two
// mistakes that were made at once; or none.
using LooksLike = std::vector<std::vector<Mistake>>;

// Whether these results of the test cases rule a mistake out.
bool is_refuted(const Mistake& mistake, const std::vector<TestCase>& tests);

// Which known mistake an answer with these results of the test cases resembles.
LooksLike what_it_looks_like(const Course& course, const Exercise& exercise,
                             const std::vector<TestCase>& tests);

}  // namespace companion
