#pragma once
// Scenes for judging a ray tracer of chapter 09 that the learner cannot have seen before: the text
// that the program reads. They are made from a seed, so that a verdict can be repeated.

#include <cstdint>
#include <string>
#include <vector>

namespace companion {

struct OwnScene {
    std::string name;        // "a fuzzy metal ball"
    std::string text;        // the scene file
    std::string suggestion;  // where to look when the picture is wrong
    std::string mesh = {};   // the file shape.obj beside it, if the scene names it
};

// One step on the way from a sky to the whole program; the last steps ask for more than pictures.
struct TaskStep {
    int number = 0;
    std::string title;
    std::vector<OwnScene> scenes;  // the pictures must equal the reference's within the noise
};

// All ten steps, in order. The tenth is optional.
std::vector<TaskStep> task_steps(std::uint64_t seed);

// Balls in the light, some in another's shadow, for a tracer whose pictures have no noise.
OwnScene lit_balls(std::uint64_t seed);

// Scenes in which rounding errors show: far, tiny, huge, nested, and scaled by 1/1000 and 1000.
std::vector<OwnScene> hard_scenes(std::uint64_t seed);

// Spheres of all materials, in a picture of this size with one sample per pixel.
std::string crowd(std::uint64_t seed, int width, int height, int spheres = 10'000);

// The same, but every second sphere appears twice, with two materials: the later one must be drawn.
std::string crowd_with_twins(std::uint64_t seed, int width, int height);

// A few spheres of all materials, seen through a lens, in a small picture: every part of a program
// runs.
std::string some_of_all(std::uint64_t seed);

// A corner that several black triangles share. The picture is so narrow that each of its rays
// passes an edge at a distance in the order of a rounding error. Behind the triangles is the sky.
OwnScene shared_corner(std::uint64_t seed);

// A mesh of 10,000 triangles, in a picture of this width with one sample per pixel.
OwnScene fine_mesh(std::uint64_t seed, int width);

// Scenes that name a broken mesh; each is named after what is wrong.
std::vector<OwnScene> broken_meshes();

// The scene that is measured for the page accuracy.md.
std::string accuracy_scene(std::uint64_t seed);

// Files that are not scenes; each is named after what is wrong.
std::vector<OwnScene> broken_scenes();

// First lines that no scene may have; they are outside the limits of the task.
struct Limits {
    std::string name;
    std::vector<std::string> scenes;
};
std::vector<Limits> broken_limits();

// Arguments that make no sense to a program, which runs in an empty folder.
struct BrokenCall {
    std::string name;
    std::vector<std::string> words;
};
std::vector<BrokenCall> broken_calls();

}  // namespace companion
