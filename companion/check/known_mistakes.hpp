#pragma once
// The known mistakes of an exercise, made and run: what fails in each tells which of them an answer
// looks like.

#include <companion/build/build.hpp>
#include <companion/check/cases.hpp>
#include <companion/check/recognition.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/mistakes.hpp>

namespace companion {

// The answer that a mistake makes.
struct MistakenAnswer {
    Mistake mistake;
    fs::path folder;    // of the answer
    BuildResult build;  // if it is not ok, there is none
};

// The answers of all known mistakes of an exercise, compiled below this folder, several at a time.
std::vector<MistakenAnswer> make_mistakes(const Course& course, const Exercise& exercise,
                                          const fs::path& below);

// What a mistake fails in. Its test cases are run twice, and more often if something else fails the
// second time: with threads, or if a time is measured.
struct WhatFails {
    std::vector<TestCase> tests;  // of one run
    Signature always = {};        // what fails every time
    bool by_chance = false;       // and something else does not
};
WhatFails what_fails(const Course& course, const MistakenAnswer& answer);

// Whether the test case that should catch a mistake fails by an assertion, and runs to its end, in
// this run of all test cases or alone.
bool is_caught(const Course& course, const MistakenAnswer& answer,
               const std::vector<TestCase>& tests);

// What fails in each known mistake of an exercise. It is found out when it is first asked for,
// which takes a few seconds, and kept in the folder of the build until mistakes, checkpoint or
// solution change.
Signatures signatures_of(const Course& course, const Exercise& exercise);

// The known mistake that an answer looks like, with those that look the same; or the two that were
// made at once; or none.
using LooksLike = std::vector<std::vector<Mistake>>;

// Whether the test cases that ended so speak against a mistake.
bool is_refuted(const Mistake& mistake, const std::vector<TestCase>& tests);

// What an answer looks like whose test cases ended so.
LooksLike what_it_looks_like(const Course& course, const Exercise& exercise,
                             const std::vector<TestCase>& tests);

}  // namespace companion
