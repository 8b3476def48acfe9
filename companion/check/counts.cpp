#include <algorithm>
#include <app/files.hpp>
#include <cmath>
#include <companion/check/counts.hpp>
#include <companion/system/files.hpp>
#include <companion/system/terminal.hpp>
#include <rt/image_file.hpp>
#include <sstream>

namespace companion {
namespace {

constexpr const char* counts_names[]{"counts_expected", "counts_yours"};

fs::path counts_file(const Course& course, const char* name) {
    return course.out() / (std::string{name} + ".png");
}

std::vector<double> numbers_in(const std::string& text) {
    std::istringstream in{text};
    std::vector<double> numbers;
    for (double number; in >> number;) numbers.push_back(number);
    return numbers;
}

std::optional<Counts> counts_in(const TestCase& test) {
    for (const FailedAssertion& failure : test.failures)
        for (const Message& message : failure.messages)
            if (auto counts = read_counts(message.counts)) return counts;
    return {};
}

}  // namespace

std::optional<Counts> read_counts(const std::string& text) {
    constexpr std::size_t most = 10'000;
    std::istringstream in{text};
    std::string columns, seen, expected;
    if (!std::getline(in, columns, ';') || !std::getline(in, seen, ';') ||
        !std::getline(in, expected))
        return {};
    const std::vector<double> width = numbers_in(columns);
    Counts counts{1, numbers_in(seen), numbers_in(expected)};
    const std::size_t cells = counts.seen.size();
    if (width.size() != 1 || !(width[0] >= 1 && width[0] <= most) || cells == 0 || cells > most ||
        counts.expected.size() != cells)
        return {};
    counts.columns = static_cast<std::size_t>(width[0]);
    if (cells % counts.columns != 0) return {};
    return counts;
}

rt::Image picture_of(const Counts& counts, const std::vector<double>& numbers) {
    const std::size_t rows = numbers.size() / counts.columns;
    const bool has_bars = rows == 1;
    const auto side = static_cast<int>(std::max<std::size_t>(1, 384 / counts.columns));
    const int width = side * static_cast<int>(counts.columns),
              height = has_bars ? 160 : side * static_cast<int>(rows);
    const double most = 1.5 * *std::max_element(counts.expected.begin(), counts.expected.end());
    const rt::Color dark = rt::from_hex(0x262a33), bright = rt::from_hex(0xffc857);
    rt::Image picture{width, height, dark};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto row = static_cast<std::size_t>(has_bars ? 0 : y / side);
            const double number =
                             numbers[row * counts.columns + static_cast<std::size_t>(x / side)],
                         part = std::clamp(most > 0 ? number / most : 0, 0.0, 1.0);
            const bool is_in_bar = height - y <= part * height;
            picture.at(x, y) =
                rt::mix(dark, bright, rt::Real(has_bars ? (is_in_bar ? 1 : 0) : part));
        }
    return picture;
}

std::string keep_counts(const Course& course, std::vector<TestCase> tests,
                        const std::string& telling) {
    forget_counts(course);
    std::stable_partition(tests.begin(), tests.end(),
                          [&](const TestCase& test) { return test.name == telling; });
    for (const TestCase& test : tests) {
        const auto counts = test.hard || test.passed ? std::nullopt : counts_in(test);
        if (!counts) continue;
        try {
            fs::create_directories(course.out());
            app::replace_file(counts_file(course, counts_names[0]),
                              rt::encode_png(picture_of(*counts, counts->expected)));
            app::replace_file(counts_file(course, counts_names[1]),
                              rt::encode_png(picture_of(*counts, counts->seen)));
        } catch (const std::exception&) {
            return "";  // the words of the check say it, too
        }
        return '\n' + wrapped("What \"" + test.name +
                                  "\" has counted, as pictures: out/counts_expected.png shows what "
                                  "was expected, out/counts_yours.png what your code gave.",
                              "  ");
    }
    return "";
}

void forget_counts(const Course& course) {
    std::error_code none;
    for (const char* name : counts_names) fs::remove(counts_file(course, name), none);
}

std::map<std::string, std::string> kept_counts(const Course& course) {
    std::map<std::string, std::string> kept;
    for (const char* name : counts_names) {
        auto bytes = app::read_bytes(counts_file(course, name));
        if (!bytes) return {};
        kept[name] = std::move(*bytes);
    }
    return kept;
}

}  // namespace companion
