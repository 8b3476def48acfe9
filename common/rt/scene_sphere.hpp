#pragma once
#include <rt/sphere.hpp>

namespace rt {

// A sphere of a scene, and which of the scene's materials it is made of.
struct SceneSphere {
    Sphere shape;
    int material = 0;
    int light = -1;  // chapter 08: which of the scene's lights it is; -1 if it is none
};

}  // namespace rt
