#pragma once
// What memory costs: this machine's times, and a model of them that is the same everywhere.

#include <memory>
#include <string>
#include <study/timing.hpp>

#include "chains.hpp"

namespace toolchain {

// Nanoseconds of processor time. Short work is repeated for a few milliseconds; work that takes
// long is done once per round, and work that takes very long in the first round only.
inline std::vector<double> in_turns_ns(const std::vector<study::Work>& works) {
    return study::in_turns_ns(works, {.at_least_ms = 2, .once_from_ms = 100});
}

// The time of one step along a chain that fills `bytes` bytes of memory, and along a plain array of
// that size.
struct Steps {
    double bytes = 0;
    double array = 0, gathered = 0, scattered = 0;  // ns
};

constexpr double smallest = 1024, largest_size = 64.0 * 1024 * 1024;

inline std::vector<Steps> measure_steps() {
    std::vector<Steps> all;
    for (double bytes = smallest; bytes <= largest_size; bytes *= 4) {
        const auto count = static_cast<std::size_t>(bytes) / sizeof(Link);
        const ScatteredChain chain{count};
        const std::vector<Link> links = rt::gathered(chain.first());
        const std::vector<Real> array(static_cast<std::size_t>(bytes) / sizeof(Real), 1);
        const auto times = in_turns_ns({[&] {
                                            Real sum = 0;
                                            for (const Real value : array) sum += value;
                                            study::keep(sum);
                                        },
                                        [&] { study::keep(rt::sum_along(links.data())); },
                                        [&] { study::keep(rt::sum_along(chain.first())); }});
        const auto steps = static_cast<double>(count);
        all.push_back({bytes, times[0] / static_cast<double>(array.size()), times[1] / steps,
                       times[2] / steps});
    }
    return all;
}

// A level of memory in the model, a cache or the RAM, in round numbers: it has room for `bytes`
// bytes, and a step to a link that it holds takes `ns` nanoseconds.
struct Level {
    const char* name;
    double bytes, ns;
};
inline constexpr Level levels[] = {{"L1", 32 * 1024.0, 1},
                                   {"L2", 1024 * 1024.0, 4},
                                   {"L3", 32 * 1024 * 1024.0, 15},
                                   {"RAM", 1e30, 90}};

// A cache that holds a tenth of a scattered chain holds the next link with probability one tenth.
// In a gathered chain, the processor fetches the next links in advance.
inline double model_scattered_ns(double bytes) {
    double time = 0, found = 0;
    for (const Level& level : levels) {
        const double within = std::min(1.0, level.bytes / bytes);
        time += (within - found) * level.ns;
        found = within;
    }
    return time;
}

inline std::vector<Steps> model_steps() {
    std::vector<Steps> all;
    for (double bytes = smallest; bytes <= largest_size; bytes *= 4)
        all.push_back({bytes, 1, 1, model_scattered_ns(bytes)});
    return all;
}

// Nanoseconds for making and destroying an object of this many bytes, measured on a thousand
// objects.
struct Objects {
    int bytes = 0;
    double stack = 0, heap = 0, together = 0;  // ns
};
constexpr int object_count = 1000;

template <int bytes>
Objects measure_objects() {
    struct Object {
        unsigned char byte[bytes];
    };
    const auto times =
        in_turns_ns({[] {
                         for (int i = 0; i < object_count; ++i) {
                             Object object;
                             study::keep(object);
                         }
                     },
                     [] {
                         for (int i = 0; i < object_count; ++i) {
                             const std::unique_ptr<Object> object{new Object};
                             study::keep(*object);
                         }
                     },
                     [] {
                         const std::unique_ptr<Object[]> all{new Object[object_count]};
                         for (int i = 0; i < object_count; ++i) study::keep(all[i]);
                     }});
    return {bytes, times[0] / object_count, times[1] / object_count, times[2] / object_count};
}

inline std::string size_text(double bytes) {
    if (bytes < 1024) return std::to_string(static_cast<int>(bytes)) + " B";
    if (bytes < 1024 * 1024) return std::to_string(static_cast<int>(bytes / 1024)) + " KiB";
    return std::to_string(static_cast<int>(bytes / (1024 * 1024))) + " MiB";
}

inline std::string steps_table(const std::vector<Steps>& all) {
    std::string text =
        "Time of one step in ns, by the size of the array or chain:\n"
        "              array   gathered chain   scattered chain\n";
    for (const Steps& steps : all) {
        char line[96];
        std::snprintf(line, sizeof line, "%8s %10.2f %16.2f %17.2f\n",
                      size_text(steps.bytes).c_str(), steps.array, steps.gathered, steps.scattered);
        text += line;
    }
    return text;
}

inline std::string objects_table(const std::vector<Objects>& all) {
    std::string text =
        "Time of one object in ns, made and destroyed again:\n"
        "              stack             heap   heap, 1000 at once\n";
    for (const Objects& objects : all) {
        char line[96];
        std::snprintf(line, sizeof line, "%8s %10.2f %16.2f %20.2f\n",
                      size_text(objects.bytes).c_str(), objects.stack, objects.heap,
                      objects.together);
        text += line;
    }
    return text;
}

}  // namespace toolchain
