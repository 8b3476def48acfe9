#include <app/errors.hpp>
#include <cmath>
#include <companion/own/accuracy.hpp>
#include <companion/own/scenes.hpp>
#include <companion/own/trial.hpp>
#include <companion/system/files.hpp>
#include <cstdlib>
#include <sstream>

namespace companion {
namespace {

constexpr std::uint64_t fixed_seed = 1;  // the page's figures must be reproducible

// The root mean square difference, in linear light, between the mean pictures of both programs,
// drawn with the same seeds.
double difference(const OwnProgram& a, const OwnProgram& b, const std::string& scene) {
    std::vector<Picture> of_a, of_b;
    for (int seed = 1; seed <= 8; ++seed) {
        const std::vector<std::string> options{"--seed", std::to_string(seed)};
        of_a.push_back(a.picture(scene, options).picture);
        of_b.push_back(b.picture(scene, options).picture);
    }
    const rt::Image mean_a = mean_of(of_a), mean_b = mean_of(of_b);
    if (!same_size(of_a[0], of_b[0])) throw app::Failure("the pictures differ in size");
    double sum = 0;
    for (std::size_t i = 0; i < mean_a.pixels().size(); ++i) {
        const rt::Color d = mean_a.pixels()[i] - mean_b.pixels()[i];
        sum += d.r * d.r + d.g * d.g + d.b * d.b;
    }
    return std::sqrt(sum / (3 * static_cast<double>(mean_a.pixels().size())));
}

bool within(double factor, double written, double measured) {
    return written <= factor * measured && measured <= factor * written;
}

}  // namespace

std::vector<AccuracyChoice> accuracy_choices(const std::string& page) {
    std::vector<AccuracyChoice> choices;
    std::istringstream lines{page};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        std::string name, value;
        if (!(words >> name >> value)) continue;
        if (name == "option:") choices.push_back({value, {}, {}});
        if (choices.empty() || (name != "time:" && name != "error:")) continue;
        std::optional<double>& figure =
            name == "time:" ? choices.back().time : choices.back().error;
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        if (end != value.c_str()) figure = number;
    }
    return choices;
}

void judge_accuracy(const Trial& trial) {
    const fs::path page = trial.request.folder / "accuracy.md";
    const auto choices =
        fs::exists(page) ? accuracy_choices(read_file(page)) : std::vector<AccuracyChoice>{};
    trial.line(
        {choices.size() >= 2, "accuracy: choices in accuracy.md", std::to_string(choices.size()),
         "two or more", "After `option:`, write what build.sh passes to the compiler."},
        [](JudgedLine&) {});
    for (const AccuracyChoice& choice : choices)
        trial.line(
            {false, "accuracy: " + choice.option, "",
             "a time within 25 % of the measured time, an error within a factor of 1.5 of the "
             "measured error",
             "Write the measured figures after `time:` and `error:` of this option."},
            [&](JudgedLine& line) {
                const OwnProgram with{trial.request.folder, {choice.option}};
                const std::vector<std::string> one{"--threads", "1"};
                const std::string scene =
                    long_enough({trial.own, one}, fixed_seed, Clock::processor, 1);
                const double time =
                    in_turns({with, one}, {trial.own, one}, scene, Clock::processor, 5).ratio;
                const double error = difference(with, trial.own, accuracy_scene(fixed_seed));
                line.actual = "measured: time " + number(time) + ", error " + number(error, "%.1e");
                if (!choice.time || !choice.error) return;
                line.actual += "; written: time " + number(*choice.time) + ", error " +
                               number(*choice.error, "%.1e");
                line.passed = within(1.25, *choice.time, time) &&
                              (error == *choice.error || within(1.5, *choice.error, error));
            });
}

}  // namespace companion
