#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <cmath>
#include <companion/build/build.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/compare/comparison.hpp>
#include <companion/follow/trail_drawing.hpp>
#include <companion/live/pictures.hpp>
#include <companion/system/process.hpp>
#include <companion/system/scratch_folder.hpp>
#include <cstdlib>
#include <rt/image_file.hpp>
#include <sstream>

namespace companion {
namespace {

// Seconds of processor time after a check that a save may cost, unless the learner insists.
constexpr double most_seconds = 3;
constexpr double coarse_pixels = 9216, fine_pixels = 230'400;  // 128 x 72, 640 x 360
constexpr double still_times = 6;  // as many, if each has a single sample
constexpr std::uint64_t seed = 1;

double work_of(const DrawingOptions& options) {
    return static_cast<double>(options.width) * options.height * std::max(1, options.spp);
}

DrawingOptions scaled_to(DrawingOptions options, double pixels) {
    const double scale = std::sqrt(pixels / (static_cast<double>(options.width) * options.height));
    if (scale >= 1) return options;
    options.width = std::max(1, static_cast<int>(std::lround(options.width * scale)));
    options.height = std::max(1, static_cast<int>(std::lround(options.height * scale)));
    return options;
}

std::string key_of(const std::string& chapter, const DrawingOptions& options) {
    std::ostringstream key;
    for (const int number : {options.width, options.height, options.spp, options.depth})
        key << number << ' ';
    key << chapter << ' ' << options.show;
    return key.str();
}

}  // namespace

void LivePictures::begin(Stage stage) {
    now_ = stage;
    spent_ = 0;
    trouble_.clear();
}

void LivePictures::forget_light() {
    followed_.reset();
    told_.clear();
    path_.clear();
}

void LivePictures::look_at(const Chapter& chapter) {
    forget_light();
    if (chapter.name != chapter_.name) {
        chapter_ = chapter;
        show_.clear();
        mine_.reset();
        solution_.reset();
        words_.clear();
        options_ = {};
        insists_ = false;
    }
    begin(placing);
}

void LivePictures::show(const std::string& word) {
    if (word == show_ ||
        (!word.empty() && !std::count(options_.shows.begin(), options_.shows.end(), word)))
        return;
    show_ = word;
    forget_light();
    if (now_ != placing && now_ != building && now_ != waiting && trouble_.empty()) begin(coarse);
}

void LivePictures::insist() {
    if (now_ != waiting) return;
    insists_ = true;
    begin(building);
}

void LivePictures::show_tracer(std::optional<Picture> mine, std::optional<Picture> ours) {
    look_at({});
    now_ = done;
    yours_ = {};
    is_fine_ = true;
    if (!mine) trouble_ = "Your tracer has no picture yet.";
    mine_ = std::move(mine);
    solution_ = std::move(ours);
    if (mine_ && solution_)
        words_ = *mine_ == *solution_ ? "The same as ours, bit for bit."
                                      : "Yours beside ours. Light that bounces at random leaves "
                                        "each its own noise.";
}

void LivePictures::follow(int column, int row) {
    if (chapter_.name.empty() || !mine_ || is_old() || column < 0 || row < 0 ||
        column >= mine_->width || row >= mine_->height)
        return;
    forget_light();
    followed_ = {column, row, 0};
    told_ =
        "Pixel " + std::to_string(column) + ',' + std::to_string(row) + ": following its light ...";
}

double LivePictures::seconds_to_build() const {
    return std::atof(app::read_bytes(seconds_file()).value_or("0").c_str());
}

fs::path LivePictures::seconds_file() const {
    return course_.build / ("seconds." + chapter_.name + "_mine");
}

fs::path LivePictures::program(const char* whose) const {
    return course_.program(chapter_.name + whose);
}

void LivePictures::step(const std::function<bool()>& is_over) try {
    const EndsRuns ends{is_over};
    const RunsAside aside;
    if (followed_) return follow_light(is_over);
    switch (now_) {
        case placing:
            yours_ = put_all_yours_in_place(course_, chapter_);
            if (!is_over()) now_ = building;
            break;
        case building:
            if (!insists_ && seconds_to_build() > most_seconds)
                now_ = waiting;
            else
                build(is_over);
            break;
        case coarse:
        case fine:
            draw(now_ == fine, is_over);
            break;
        case coarse_solution:
            solution_ = solutions_picture(coarse_options_);
            if (is_over()) break;
            words_ = compared();
            now_ = finer() ? fine : done;
            break;
        case waiting:
        case done:
            break;
    }
} catch (const std::exception& failure) {
    if (is_over()) return;
    const bool has_coarse = now_ == fine;
    now_ = done;
    if (has_coarse) return;
    trouble_ = failure.what();
    mine_.reset();
    solution_.reset();
    words_.clear();
}

void LivePictures::follow_light(const std::function<bool()>& is_over) {
    const Followed followed = *followed_;
    const std::string program_name = chapter_.name + "_follow";
    const BuildResult built = companion::build(course_, {program_name});
    if (is_over()) return;
    forget_light();
    told_ = "Pixel " + std::to_string(followed.column) + ',' + std::to_string(followed.row);
    if (!built.ok) {
        told_ += ": its light cannot be followed in chapter " + chapter_.number() + '.';
        return;
    }
    const ScratchFolder scratch{"course-follow"};
    std::vector<std::string> command{course_.program(program_name).string(), "--quiet", "--out",
                                     (scratch.path() / "picture.ppm").string()};
    for (std::string& word : words_for(shown_options_, seed)) command.push_back(std::move(word));
    const auto [trail, result] = record(followed, {.command = command, .timeout = 20});
    if (has_step(trail, "ray")) {
        told_ += ", sample 0\n" + in_words(trail);
        path_ = drawn(trail, {rt::encode_png(mean_of({*mine_})), mine_->width, mine_->height});
    } else if (result.ok()) {
        told_ += ": the program sends no ray through it, or many at once.\n";
    }
    if (!result.ok()) told_ += "The program ended: " + how_it_ended(result) + '\n';
}

void LivePictures::build(const std::function<bool()>& is_over) {
    if (options_.width == 0) {  // once for a chapter
        must_build(course_, chapter_.name + "_solution");
        if (is_over()) return;
    }
    const BuildResult built = companion::build(course_, {chapter_.name + "_mine"});
    if (is_over()) return;
    // Whoever waited for more than that waits for a fine picture, too.
    if (built.cpu_seconds < most_seconds) spent_ += built.cpu_seconds;
    // An error ends it sooner; and if nothing was compiled, nothing is known.
    if (built.ok && built.cpu_seconds > 1)
        app::replace_file(seconds_file(), std::to_string(built.cpu_seconds));
    if (!built.ok) {
        const std::string error = first_error(course_, built.output, yours_.files);
        throw app::Failure("It does not compile: " + error.substr(0, error.find('\n')));
    }
    now_ = coarse;
}

Picture LivePictures::solutions_picture(const DrawingOptions& options) {
    const std::string key = key_of(chapter_.name, options);
    const auto known = drawn_.find(key);
    if (known != drawn_.end()) return known->second;
    const Picture picture =
        draw_with(program("_solution"), options, seed, 2 * most_seconds, &spent_);
    return drawn_[key] = picture;
}

// The options of the fine picture, as `compare` has them, with as many samples as may still be
// paid for; nothing if they are too few.
std::optional<DrawingOptions> LivePictures::finer() const {
    DrawingOptions options = scaled_to(for_comparison(options_), fine_pixels);
    options.show = show_;
    const double left = most_seconds - spent_, cost = coarse_ / work_of(coarse_options_);
    const double both = drawn_.count(key_of(chapter_.name, options)) ? 1 : 2;
    const double samples = left / (both * cost * options.width * options.height);
    if (options.spp > 0) options.spp = std::min(options.spp, static_cast<int>(samples));
    if (samples < 1 || work_of(options) <= work_of(coarse_options_)) return {};
    return options;
}

void LivePictures::draw(bool is_fine, const std::function<bool()>& is_over) {
    if (!is_fine) {
        if (options_.width == 0) options_ = options_of(program("_solution"));
        coarse_options_ = scaled_to(for_comparison(options_),
                                    coarse_pixels * (options_.has_seed ? 1 : still_times));
        coarse_options_.spp = std::min(1, options_.spp);
        coarse_options_.show = show_;
        coarse_ = 0;
        const Picture picture =
            draw_with(program("_mine"), coarse_options_, seed, most_seconds, &coarse_);
        if (is_over()) return;
        spent_ += coarse_;
        mine_ = picture;
        shown_options_ = coarse_options_;
        is_fine_ = false;
        solution_.reset();
        words_.clear();
        now_ = coarse_solution;
        return;
    }
    const auto options = finer();
    if (!options) {
        now_ = done;
        return;
    }
    const Picture mine = draw_with(program("_mine"), *options, seed, 2 * most_seconds);
    const Picture solution = solutions_picture(*options);
    if (is_over()) return;
    mine_ = mine;
    shown_options_ = *options;
    solution_ = solution;
    words_ = compared();
    is_fine_ = true;
    now_ = done;
}

std::string LivePictures::compared() const {
    if (!mine_ || !solution_) return {};
    if (*mine_ == *solution_) return "The same as the solution's, bit for bit.";
    const std::string number = chapter_.number();
    if (options_.has_seed && same_size(*mine_, *solution_))
        return "It differs from the solution's, which has the same random numbers. Whether more "
               "than noise differs: ./course compare " +
               number + (yours_.failing.empty() ? "" : " --mine");
    std::vector<std::string> lines = compare_still(*mine_, *solution_).words();
    // In false colors, nothing is too dark or too red.
    if (!show_.empty() && lines.size() > 2) lines.resize(2);
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

}  // namespace companion
