#include <CLI/CLI.hpp>
#include <algorithm>
#include <app/files.hpp>
#include <app/json.hpp>
#include <app/limits.hpp>
#include <app/nearest_word.hpp>
#include <app/platform.hpp>
#include <app/run.hpp>
#include <app/threads.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <locale>
#include <rt/image_file.hpp>
#include <rt/light_file.hpp>
#include <rt/portable.hpp>
#include <sstream>
#include <study/report.hpp>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr int max_side = 65'536;
constexpr double most_stops = 32;
const std::string image_files = ".png, .ppm, .hdr or .pfm";

// What the command line requests.
struct Request {
    Settings settings;
    std::string out, study_folder;
    bool explain = false, quiet = false, describe = false;
};

// Rejects everything except whole numbers within the range, and says what would be right.
CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
    return {[=](const std::string& text) -> std::string {
                std::uint64_t value = 0;
                const char* const end = text.data() + text.size();
                const auto [stop, error] = std::from_chars(text.data(), end, value);
                if (error == std::errc{} && stop == end && low <= value && value <= high) return {};
                return '\'' + text + "' is not a whole number from " + std::to_string(low) +
                       " to " + std::to_string(high);
            },
            "", "whole number"};
}

// The number that a text consists of. The decimal point is that of C++, whatever the language of
// the machine.
std::optional<double> number_in(const std::string& text) {
    if (text.find_first_of("xX") != std::string::npos) return {};  // libc++ would also accept 0x1
    std::istringstream in{text};
    in.imbue(std::locale::classic());
    double number = 0;
    if (!(in >> number) || in.peek() != std::istringstream::traits_type::eof()) return {};
    return number;
}

constexpr double farthest = 1e9;  // coordinates of the camera

// The point that is meant by a text such as "1,-0.5,2".
std::optional<rt::Vec3> point_in(const std::string& text) {
    std::vector<rt::Real> numbers;
    std::istringstream parts{text + ','};
    for (std::string part; std::getline(parts, part, ',');) {
        const std::optional<double> number = number_in(part);
        if (!number || !(std::abs(*number) <= farthest)) return {};
        numbers.push_back(static_cast<rt::Real>(*number));
    }
    if (numbers.size() != 3) return {};
    return rt::Vec3{numbers[0], numbers[1], numbers[2]};
}

// The angle, in radians, that is meant by a text such as "33.5". The text gives degrees, which must
// be between 0 and 180.
std::optional<rt::Real> angle_in(const std::string& text) {
    const std::optional<double> degrees = number_in(text);
    if (!degrees) return {};
    const rt::Real angle = rt::radians(static_cast<rt::Real>(*degrees));
    if (!(0 < angle && angle < rt::pi)) return {};
    return angle;
}

std::string text_of(rt::Real number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", static_cast<double>(number));
    return text;
}
std::string text_of(rt::Vec3 p) {
    return text_of(p.x) + ',' + text_of(p.y) + ',' + text_of(p.z);
}

// Checks before the work starts that the image can be written, so that no finished image is lost.
void check_output(const fs::path& path) {
    const std::string name = "--out: " + path.string();
    if (path.empty()) throw UsageError("--out: needs a file name that ends in " + image_files);
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::status_known(status)) throw Failure(name + ": " + error.message());
    if (fs::is_directory(status)) throw UsageError(name + " is a folder; name a file in it");
    const bool is_device = fs::exists(status) && !fs::is_regular_file(status);
    const std::string extension = path.extension().string();
    const bool is_known =
        extension == ".png" || extension == ".ppm" || extension == ".hdr" || extension == ".pfm";
    if (!is_known && !is_device)
        throw UsageError(name + " has an unknown extension, or none; use " + image_files);
    const fs::path target = is_device ? path : behind_links(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path{"."};
    if (!fs::is_directory(folder, error))
        throw Failure("--out: the folder " + folder.string() +
                      (target == path ? "" : ", to which the link " + path.string() + " points,") +
                      " does not exist; create it, or name another one");
    if (fs::exists(status) && !is_writable(path))
        throw Failure(name + " exists and is not writable (" + std::strerror(errno) +
                      "); name another file");
    if (!is_device && !is_writable(folder))
        throw Failure("--out: the folder " + folder.string() + " is not writable (" +
                      std::strerror(errno) + "); name another one");
}

std::string encode(const Program& program, const std::string& extension, const rt::Image& image) {
    if (extension == ".png") return rt::encode_png(image);
    if (extension == ".hdr") return rt::encode_hdr(image);
    if (extension == ".pfm") return rt::encode_pfm(image);
    return program.encode_ppm ? program.encode_ppm(image) : rt::encode_ppm(image);
}

void write_image(const Program& program, const fs::path& path, const rt::Image& image) {
    const std::string bytes = encode(program, path.extension().string(), image);
    try {
        app::replace_file(path, bytes);
    } catch (const std::system_error& error) {
        throw Failure("--out: " + path.string() + " cannot be written (" + error.code().message() +
                      "); free some space there, or name another file");
    }
}

std::string count(double number, const char* unit) {
    const char* const prefixes[] = {"", " thousand", " million", " billion"};
    int i = 0;
    for (; number >= 1000 && i < 3; ++i) number /= 1000;
    char text[64];
    std::snprintf(text, sizeof text, "%.3g%s %s", number, prefixes[i], unit);
    return text;
}

// Opens a pipe before the work starts, so that a missing reader is found at once. The pipe then
// stays open, because closing it would end the reader.
class HeldPipe {
  public:
    explicit HeldPipe(const fs::path& path) {
        if (!fs::is_fifo(path)) return;
        // A reader that was started at the same time as this program may need a moment.
        for (int tries = 0; !file_ && tries < 100; ++tries) {
            if (tries > 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
            file_ = open_for_writing(path, false);
        }
        if (!file_)
            throw Failure(
                "--out: " + path.string() +
                " is a pipe that nobody reads from; start the reader first, or name a file");
    }
    ~HeldPipe() {
        if (file_) std::fclose(file_);
    }
    HeldPipe(const HeldPipe&) = delete;
    HeldPipe& operator=(const HeldPipe&) = delete;

  private:
    std::FILE* file_ = nullptr;
};

// If the system does not allow as many threads as were requested, uses fewer and says so.
void check_threads(const Program& program, const Request& request, Settings& settings) {
    if (settings.threads == 0) return;
    const int wanted = settings.threads;
    settings.threads = threads_that_start(wanted);
    if (settings.threads == 0)
        throw Failure("no thread can be started: the system already has too many (ulimit -u)");
    if (settings.threads < wanted && !request.quiet)
        std::fprintf(stderr, "%s: only %d of %d threads can be started; it continues with these\n",
                     program.name.c_str(), settings.threads, wanted);
}

// Makes the picture brighter by a factor of 2 for each stop.
void expose(rt::Image& image, double stops) {
    if (stops == 0) return;
    const auto factor = static_cast<rt::Real>(rt::portable::exp2(stops));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image.at(x, y) *= factor;
}

// Returns the program's exit code.
int draw_picture(const Program& program, const Request& request) {
    const fs::path path = request.out;
    check_output(path);
    const HeldPipe pipe{path};
    // The report must not end up in an image that goes to the standard output.
    std::error_code none;
    std::FILE* const out =
        !fs::exists(path, none) || fs::is_regular_file(path, none) ? stdout : stderr;
    Settings settings = request.settings;
    check_threads(program, request, settings);
    if (request.explain && !request.quiet)
        settings.explain = [out](const std::string& words) {
            std::fputs(words.c_str(), out);
            std::fflush(out);
        };
    const auto start = std::chrono::steady_clock::now();
    Picture picture;
    {
        Progress progress{!request.quiet && (program.has_terminal || is_terminal(stderr))};
        picture = program.render(settings, progress);
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

    if (settings.exposure) expose(picture.image, *settings.exposure);
    const int percent = picture.stopped ? static_cast<int>(100 * picture.stopped->share_done) : 100;
    // An empty picture must not replace an older one.
    const bool keeps_older = percent == 0 && fs::is_regular_file(path, none);
    if (!keeps_older) write_image(program, path, picture.image);
    if (picture.stopped) {
        const std::string is_done = std::to_string(percent);
        std::fprintf(stderr, "%s: stopped by %s; %s %s\n", program.name.c_str(),
                     picture.stopped->signal == SIGINT ? "Ctrl-C" : "SIGTERM",
                     path.string().c_str(),
                     keeps_older ? "is unchanged, since nothing is done yet"
                                 : ("shows the " + is_done + " % that are done").c_str());
        return stopped_by + picture.stopped->signal;
    }
    if (request.quiet) return done;
    const auto rays = static_cast<double>(picture.rays);
    std::fprintf(out, "%s: %dx%d pixels in %.3f s", path.string().c_str(), picture.image.width(),
                 picture.image.height(), seconds.count());
    if (picture.rays)
        std::fprintf(out, ", %s, %s", count(rays, "rays").c_str(),
                     count(rays / seconds.count(), "rays/s").c_str());
    std::fputc('\n', out);
    if (picture.words) std::fputs(picture.words().c_str(), out);
    return done;
}

void run_study(const Program& program, const Request& request) {
    const fs::path folder = request.study_folder;
    const auto fail = [&](const std::error_code& error) {
        throw Failure("--study: " + folder.string() + " is not writable (" + error.message() +
                      "); name another folder");
    };
    if (folder.empty()) throw UsageError("--study: needs the name of a folder");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail(error);
    // Checked before the work starts, so that no result is lost.
    if (!is_writable(folder)) fail({errno, std::generic_category()});
    study::Report report{program.name};
    program.study(report);
    try {
        write_study(report, folder);
    } catch (const std::system_error& full) {
        fail(full.code());
    }
    if (!request.quiet) report.print_table(stdout);
}

std::string exit_codes(const Program& program) {
    std::string codes =
        "Exit codes: 0 success, 1 something failed, 2 bad usage or input, 3 an exercise is "
        "still to be written";
    if (program.can_be_stopped)
        codes += ", 130 stopped by Ctrl-C (143 by SIGTERM): the image shows the part that was done";
    return codes;
}

// Adds the options for those numeric settings that the program has.
void add_numbers(CLI::App& options, Settings& settings) {
    const auto add = [&](const char* name, int& value, const char* what, int high) {
        if (value == 0) return;  // this program has no such setting
        options.add_option(name, value, what)
            ->check(whole_number(1, static_cast<std::uint64_t>(high)))
            ->capture_default_str();
    };
    add("--width", settings.width, "Width in pixels", max_side);
    add("--height", settings.height, "Height in pixels", max_side);
    add("--spp", settings.spp, "Samples per pixel", 1'000'000);
    add("--depth", settings.depth, "Maximum number of bounces of a path", 1'000'000);
    add("--threads", settings.threads, "Number of threads that render", 1024);
    if (settings.seed)
        options.add_option("--seed", *settings.seed, "Seed of the random numbers")
            ->check(whole_number(0, UINT64_MAX))
            ->capture_default_str();
}

// Adds the options for where the camera stands and what it sees, for programs whose camera can be
// moved.
void add_view(CLI::App& options, rt::View& view) {
    const auto add_point = [&](const char* name, rt::Vec3& point, const char* what) {
        options
            .add_option_function<std::string>(
                name, [&point](const std::string& text) { point = *point_in(text); }, what)
            ->check(CLI::Validator{[](const std::string& text) -> std::string {
                                       if (point_in(text)) return {};
                                       return '\'' + text +
                                              "' is not a point, such as 1,-0.5,2: "
                                              "three numbers from -1e9 to 1e9 with commas between";
                                   },
                                   "", "point"})
            ->type_name("X,Y,Z")
            ->default_str(text_of(point));
    };
    add_point("--from", view.from, "Position of the camera");
    add_point("--at", view.at, "The point that the camera looks at");
    options
        .add_option_function<std::string>(
            "--fov", [&view](const std::string& text) { view.vertical_fov = *angle_in(text); },
            "Vertical field of view in degrees")
        ->check(CLI::Validator{[](const std::string& text) -> std::string {
                                   if (angle_in(text)) return {};
                                   return '\'' + text + "' is not a number between 0 and 180";
                               },
                               "", "degrees"})
        ->type_name("DEG")
        ->default_str(text_of(view.vertical_fov * 180 / rt::pi));
}

// Adds the option for how bright the picture's file is.
void add_exposure(CLI::App& options, double& stops) {
    const auto is_right = [](const std::string& text) -> std::string {
        const std::optional<double> number = number_in(text);
        if (number && std::abs(*number) <= most_stops) return {};
        return '\'' + text + "' is not a number of stops from -32 to 32";
    };
    options
        .add_option_function<std::string>(
            "--exposure", [&stops](const std::string& text) { stops = *number_in(text); },
            "Brightness: each stop doubles the light, or halves it if negative")
        ->check(CLI::Validator{is_right, "", "stops"})
        ->type_name("STOPS")
        ->default_str("0");
}

// Rejects everything except the words that --show knows in this program.
CLI::Validator shown_word(const std::vector<std::string>& known) {
    std::string list;
    for (const std::string& word : known) list += (list.empty() ? "" : ", ") + word;
    return {[=](const std::string& text) -> std::string {
                if (std::count(known.begin(), known.end(), text) > 0) return {};
                return "this program cannot show '" + text + "', only: " + list;
            },
            list, "shown word"};
}

// Adds all options, in the order in which --help lists them. The request must keep its address
// until the options are parsed.
void add_options(CLI::App& options, Request& request, const Program& program) {
    Settings& settings = request.settings;
    options.set_help_flag("--help", "Show this help and exit");
    options.footer(exit_codes(program) + (program.others.empty() ? "" : "\n" + program.others));
    options.add_option("--out", request.out, "The image file, " + image_files)
        ->capture_default_str();
    add_numbers(options, settings);
    if (settings.view) add_view(options, *settings.view);
    if (settings.exposure) add_exposure(options, *settings.exposure);
    for (const auto& [name, about, words] : program.choices) {
        settings.choices[name] = words.front();
        options.add_option("--" + name, settings.choices[name], about)
            ->check(CLI::IsMember(words))
            ->capture_default_str();
    }
    if (!program.shows.empty())
        options
            .add_option("--show", settings.show,
                        "Draw in false colors what the code computes, instead of the picture")
            ->check(shown_word(program.shows));
    for (const Number& number : program.numbers)
        options
            .add_option_function<std::string>(
                "--" + number.name,
                [&settings, name = number.name](const std::string& text) {
                    settings.numbers[name] = *number_in(text);
                },
                number.about)
            ->check(CLI::Validator{[](const std::string& text) -> std::string {
                                       const std::optional<double> given = number_in(text);
                                       if (given && *given > 0) return {};
                                       return '\'' + text + "' is not a number greater than 0";
                                   },
                                   "", "number"})
            ->type_name("NUMBER");
    for (const Flag& flag : program.flags) options.add_flag("--" + flag.name, flag.about);
    if (!program.reads.empty()) options.add_option("file", settings.file, program.reads);
    if (program.explains)
        options.add_flag("--explain", request.explain,
                         "Explain what the program is about to do, and why");
    options.add_flag("--quiet", request.quiet, "Print only errors");
    options.add_flag("--describe", request.describe)->group("");  // not in --help
    if (program.study)
        options.add_option("--study", request.study_folder,
                           "Measure accuracy against time instead of drawing; write the tables to "
                           "this folder");
}

// Checks that involve more than one option.
void check_together(const Settings& settings) {
    if (settings.given.count("file") > 0 && settings.file.empty())
        throw UsageError("file: needs a name");
    if (!settings.show.empty() && settings.given.count("exposure") > 0)
        throw UsageError("--show and --exposure exclude each other: false colors are not light");
    if (settings.view && settings.view->from == settings.view->at)
        throw UsageError("--from and --at are both " + text_of(settings.view->at) +
                         ": the camera needs two different points to know where it looks");
    if (std::int64_t{settings.width} * settings.height > most_pixels)
        throw UsageError("--width " + std::to_string(settings.width) + " times --height " +
                         std::to_string(settings.height) + " is more than " +
                         std::to_string(most_pixels) + " pixels");
}

Request default_request(const Program& program) {
    return {program.defaults, program.name + ".png", {}};
}

// What to say about an argument that the parser does not know.
std::string advice(const CLI::App& options, int argc, const char* const* argv,
                   const std::string& others) {
    std::vector<std::string> known;
    for (const CLI::Option* const option : options.get_options())
        if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
    for (int i = 1; i < argc; ++i) {
        const std::string word = std::string{argv[i]}.substr(0, std::string{argv[i]}.find('='));
        if (word.rfind("--", 0) != 0 || std::count(known.begin(), known.end(), word) > 0) continue;
        if (const std::string meant = nearest_word(word, known); !meant.empty())
            return "; did you mean " + meant + '?';
    }
    return "; --help lists the options" + (others.empty() ? "" : ", and " + others);
}

int run_or_throw(int argc, const char* const* argv, const Program& program) {
    Request request = default_request(program);
    CLI::App options{program.name + ": " + program.about};
    add_options(options, request, program);
    try {
        options.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::fputs(options.help().c_str(), stdout);
        return done;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what() + advice(options, argc, argv, program.others));
    }
    for (const CLI::Option* const option : options.get_options())
        if (option->count() > 0) request.settings.given.insert(option->get_single_name());
    if (request.describe) {
        std::puts(describe(program).c_str());
        return done;
    }
    check_together(request.settings);

    if (request.settings.given.count("study") == 0) return draw_picture(program, request);
    run_study(program, request);
    return done;
}

}  // namespace

Progress::~Progress() {
    if (visible_ && (steps_ > 0 || has_said_)) std::fputs("\r\033[K", stderr);
}

void Progress::say(const std::string& what) {
    if (!visible_) return;
    std::fprintf(stderr, "\r\033[K%s", what.c_str());
    std::fflush(stderr);
    has_said_ = true;
}

void Progress::start(int steps) {
    done_ = 0;
    steps_ = steps;
    if (has_said_) say("");
}

void Progress::step() {
    const int done_now = ++done_;
    if (!visible_) return;
    constexpr int bar_length = 40;
    const auto filled_at = [&](std::int64_t n) {
        return static_cast<int>(n * bar_length / std::max(steps_.load(), 1));
    };
    const int filled = filled_at(done_now);
    if (filled == filled_at(done_now - 1)) return;
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(bar_length - filled), '.');
    std::fprintf(stderr, "\r[%s] %3d %%", bar.c_str(), filled * 100 / bar_length);
}

std::string describe(const Program& program) {
    Request request = default_request(program);
    CLI::App options;
    add_options(options, request, program);
    std::map<std::string, std::string> defaults;
    for (const CLI::Option* const option : options.get_options())
        defaults[option->get_single_name()] = option->get_default_str();
    for (const std::string& word : program.shows)
        defaults["show"] += (defaults["show"].empty() ? "" : " ") + word;
    return to_json(defaults);
}

void write_study(const study::Report& report, const std::filesystem::path& folder) {
    const fs::path path = folder / report.file();
    std::ifstream earlier{path};
    const std::string csv = report.csv(earlier);
    earlier.close();  // Windows cannot replace an open file
    replace_file(path, csv);
}

int run(int argc, const char* const* argv, const Program& program) {
    return run_or_explain(program.name, [&] { return run_or_throw(argc, argv, program); });
}

}  // namespace app
