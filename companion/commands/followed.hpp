#pragma once
// Tells and draws what the light of one sample does, for `run` and `tracer`.

#include <companion/compare/picture.hpp>
#include <companion/follow/record.hpp>
#include <companion/model/course.hpp>
#include <functional>
#include <string>
#include <vector>

namespace companion {

// Reads "X,Y" or "X,Y,SAMPLE". Throws app::UsageError for anything else.
Followed followed_in(const std::string& text);

struct FollowRequest {
    Followed followed;
    std::vector<std::string> command;  // the program, made with companion/follow/recorder
    fs::path picture;                  // .ppm, which it writes if it draws to its end
    std::function<Picture()> draw;     // draws what is below the path
    fs::path drawing;                  // .svg, to be written
};

// Returns the exit code. Throws app::UsageError if the pixel or the sample does not exist.
int follow(const Course& course, const FollowRequest& request);

}  // namespace companion
