#pragma once
// Scenes for judging a ray tracer of chapter 09 that nobody has seen before: the text that the
// program reads, made from a seed, so that a verdict can be repeated.

#include <cstdint>
#include <string>
#include <vector>

namespace companion {

struct OwnScene {
    std::string name;        // "a fuzzy metal ball"
    std::string text;        // the scene file
    std::string suggestion;  // where to look when the picture is wrong
    std::string mesh = {};   // the file shape.obj beside it, if it names one
};

// One step from a sky to the whole program; the last ones ask for more than pictures.
struct Rung {
    int number = 0;
    std::string title;
    std::vector<OwnScene> scenes;  // whose pictures must be the reference's within the noise
};

// All ten, in order. The tenth is optional.
std::vector<Rung> own_rungs(std::uint64_t seed);

// Scenes in which rounding shows: far, tiny, huge, nested, and scaled by 1/1000 and 1000.
std::vector<OwnScene> hard_scenes(std::uint64_t seed);

// Spheres of all materials, in a picture of this size with one sample a pixel.
std::string crowd(std::uint64_t seed, int width, int height, int spheres = 10'000);

// The same, but every second sphere appears twice, with two materials: the later one counts.
std::string crowd_with_twins(std::uint64_t seed, int width, int height);

// A few spheres of all materials through a lens, in a small picture, so that
// each part of a program runs.
std::string some_of_all(std::uint64_t seed);

// A corner that several black triangles share, in a picture so narrow that each of its rays passes
// within rounding of an edge. Behind them is the sky.
OwnScene shared_corner(std::uint64_t seed);

// A mesh of 10,000 triangles, in a picture of this width with one sample a pixel.
OwnScene fine_mesh(std::uint64_t seed, int width);

// Scenes that name a mesh, and what is wrong with each.
std::vector<OwnScene> broken_meshes();

// The scene for measuring the page accuracy.md.
std::string accuracy_scene(std::uint64_t seed);

// Files that are not scenes, and what is wrong with each.
std::vector<OwnScene> broken_scenes();

// Words after the program's name that make no sense to it. It runs in an empty folder.
struct BrokenCall {
    std::string name;
    std::vector<std::string> words;
};
std::vector<BrokenCall> broken_calls();

}  // namespace companion
