#pragma once
#include <rt/false_colors.hpp>
#include <rt/scene_text.hpp>
#include <string>
#include <thread>
#include <vector>

namespace rt {

// How a tracer was called (given): SCENE PICTURE.ppm [--threads N] [--seed N] [--list]
// [--show WORD]
struct TracerCall {
    std::string scene, picture;  // files
    int threads = 1;             // all cores, unless --threads says otherwise
    int seed = 1;
    bool list = false;  // find the nearest sphere by testing each one
    std::string show;   // what to draw in false colors, or empty
};

// Reads the words of the command line; words[0] is the program's name. Throws
// std::invalid_argument, which says what was expected.
inline TracerCall read_call(int count, char** words) {
    TracerCall call;
    call.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::string> files;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--list") {
            call.list = true;
        } else if (word == "--show") {
            expect(++i < count && shown_words().count(words[i]) > 0,
                   "direction, normal, distance, sphere, bounces or samples after --show");
            call.show = words[i];
        } else if (word == "--threads" || word == "--seed") {
            expect(++i < count, "a number after " + word);
            std::istringstream in{words[i]};
            int& number = word == "--seed" ? call.seed : call.threads;
            expect(in >> number && in.eof() && number > 0, "a whole number after " + word);
        } else {
            files.push_back(word);
        }
    }
    expect(files.size() == 2, "SCENE PICTURE.ppm [--threads N] [--seed N] [--list] [--show WORD]");
    call.scene = files[0];
    call.picture = files[1];
    return call;
}

}  // namespace rt
