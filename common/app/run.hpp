#pragma once
// What the programs of all chapters share: reading the command line, a progress bar, writing the
// image, saying how long it took, and ending with the right exit code.

#include <app/errors.hpp>
#include <app/interrupt.hpp>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <rt/image.hpp>
#include <rt/view.hpp>
#include <set>
#include <string>
#include <vector>

namespace study {
class Report;
}

namespace app {

// What the user asked for. A setting whose default is 0 is not an option of the program: a program
// without randomness, for example, has no option for samples.
struct Settings {
    int width = 960;   // pixels
    int height = 540;  // pixels
    int spp = 0;       // samples per pixel
    int depth = 0;     // the most bounces of a path
    int threads = 0;
    std::optional<std::uint64_t> seed = {};  // of everything random
    // Where the camera stands, what it looks at, and how much it sees. None if the camera cannot be
    // moved.
    std::optional<rt::View> view = {};
    // The word that was chosen for each of Program::choices, by name.
    std::map<std::string, std::string> choices = {};
    // Which of Program::shows should be drawn; empty for the chapter's picture.
    std::string show = {};
    // The values given for Program::numbers, by name.
    std::map<std::string, double> numbers = {};
    // How much brighter the picture's file is than the light, in stops: each doubles it. None if
    // the program has no --exposure.
    std::optional<double> exposure = {};
    // The file that the program was given to read; empty if none.
    std::string file = {};
    // The options that were given, without the dashes: they take precedence over what a file says.
    std::set<std::string> given = {};
    // Prints what the program is about to do, and why; empty unless --explain asks for it.
    std::function<void(const std::string&)> explain = {};

    // The word that was chosen for one of Program::choices.
    const std::string& choice(const std::string& name) const { return choices.at(name); }
};

// An option that only one program has, and that takes one of a few words:
// --ending sky|black|roulette.
struct Choice {
    std::string name;                // without the dashes
    std::string about;               // what is chosen
    std::vector<std::string> words;  // the first is the default
};

// An option that only one program has, and that takes no value: Settings::given
// says whether it was given.
struct Flag {
    std::string name;   // without the dashes
    std::string about;  // what it does
};

// An option that only one program has, and that takes a number greater than 0. It has no default.
struct Number {
    std::string name;   // without the dashes
    std::string about;  // what it does, and its unit
};

// Counts the work that is done, for the progress bar. Several threads may use it at once.
class Progress {
  public:
    explicit Progress(bool visible) : visible_{visible} {}
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Sets the number of steps (rows, tiles); the bar starts at zero.
    void start(int steps);
    void step();
    // Says what is being done before the first step, such as "reading pot.obj"; the next words, or
    // the bar, take its place.
    void say(const std::string& what);

  private:
    bool visible_, has_said_ = false;
    std::atomic<int> steps_ = 0, done_ = 0;
};

// What a program drew, and the number of rays that it followed.
struct Picture {
    rt::Image image;
    std::uint64_t rays = 0;
    // Returns more lines to print below the one about the image. Called only if that line is
    // printed.
    std::function<std::string()> words = {};
    // What stopped the work early, if anything did. The unfinished pixels then show the
    // checkerboard of draw_unfinished.
    std::optional<Stopped> stopped = {};
};

// A chapter's program.
struct Program {
    std::string name;   // such as "03_sphere"
    std::string about;  // one sentence: what the picture shows
    Settings defaults;
    std::function<Picture(const Settings&, Progress&)> render;
    void (*study)(study::Report&);
    // How a .ppm file is encoded, if the chapter has its own way.
    std::string (*encode_ppm)(const rt::Image&) = nullptr;
    std::vector<Choice> choices = {};
    std::vector<Flag> flags = {};
    std::vector<Number> numbers = {};
    // The words that --show accepts, one for each thing that it draws in false colors; if there are
    // none, the program has no --show.
    std::vector<std::string> shows = {};
    // Describes the file that may be named without an option; empty if the program reads no file.
    std::string reads = {};
    // Said of an unknown option: who else has options; empty if nobody.
    std::string others = {};
    // Whether render() calls Settings::explain when it is set; if not, the program has no
    // --explain.
    bool explains = false;
    // Whether render() checks for an Interruption; if not, Ctrl-C ends the program at once.
    bool can_be_stopped = false;
    // Whether the output to stderr reaches a terminal although stderr is a pipe, as can happen
    // under mpirun.
    bool has_terminal = false;
};

// The Program::study of a chapter's program: its study.cpp defines it. A program without a
// study.cpp gets that of no_study.cpp, nullptr.
extern void (*const program_study)(study::Report&);

// Does all that main() has to do, and returns the exit code. Every error is one line on stderr.
int run(int argc, const char* const* argv, const Program& program);

// Writes measurements to folder/CHAPTER.csv, and keeps those that the file already has for the
// other precision. Throws std::system_error on failure.
void write_study(const study::Report& report, const std::filesystem::path& folder);

// What the hidden option --describe prints for other programs that run this one: the options of
// this program, each with its default, as a JSON object whose values are texts. --show has no
// default: its value is the words that it accepts.
std::string describe(const Program& program);

// Draws an image row by row: calls shade(x, y) for each pixel, and advances the progress with each
// row. Pixels is the type that holds the pixels, such as Canvas<Color>.
template <class Pixels = rt::Image, class Shade>
rt::Image draw(const Settings& settings, Progress& progress, Shade shade) {
    progress.start(settings.height);
    return rt::make_image<Pixels>(settings.width, settings.height, [&](int x, int y) {
        if (x == settings.width - 1) progress.step();
        return shade(x, y);
    });
}

}  // namespace app
