// What accuracy costs when numbers are added up, and what memory costs.

#include <app/run.hpp>
#include <functional>
#include <rt/rng.hpp>
#include <study/double_double.hpp>
#include <study/report.hpp>
#include <study/ulp.hpp>
#include <type_traits>

#include "memory_times.hpp"
#include "sums.hpp"

namespace toolchain {
namespace {

using study::DoubleDouble;

void study_sums(study::Report& report) {
    std::vector<Real> terms(10'000'000);
    Rng rng{3, 1};
    for (Real& term : terms) term = rng.uniform();
    const Sums strict = strict_sums(), fast = fast_math_sums();
    struct Variant {
        const char* name;
        std::function<Real(const Real*, std::size_t)> sum;
    };
    std::vector<Variant> variants{{"naive", strict.naive},
                                  {"pairwise", strict.pairwise},
                                  {"compensated", strict.compensated},
                                  {"naive, fast-math", fast.naive},
                                  {"pairwise, fast-math", fast.pairwise},
                                  {"compensated, fast-math", fast.compensated}};
    if (std::is_same_v<Real, float>)
        variants.push_back({"naive, added in double", [](const Real* x, std::size_t count) {
                                double sum = 0;
                                for (std::size_t i = 0; i < count; ++i)
                                    sum += static_cast<double>(x[i]);
                                return static_cast<Real>(sum);
                            }});
    for (std::size_t count = 1000; count <= terms.size(); count *= 10) {
        DoubleDouble exact;
        for (std::size_t i = 0; i < count; ++i)
            exact = exact + DoubleDouble(static_cast<double>(terms[i]));
        std::vector<study::Work> works;
        for (const Variant& variant : variants)
            works.push_back([&] { study::keep(variant.sum(terms.data(), count)); });
        const auto times = in_turns_ns(works);
        // A single sum may be right by luck, so the error is the root mean square over eight orders
        // of the same terms, or over four orders if there are many terms.
        const std::size_t orders = count < 1'000'000 ? 8 : 4;
        std::vector<double> squares(variants.size());
        for (std::size_t order = 0; order < orders; ++order) {
            for (std::size_t i = 0; i < variants.size(); ++i) {
                const Real sum = variants[i].sum(terms.data(), count);
                squares[i] += std::pow(study::error_in_ulp(sum, exact), 2);
            }
            const auto begin = terms.begin();
            std::rotate(begin, begin + static_cast<std::ptrdiff_t>(count / orders),
                        begin + static_cast<std::ptrdiff_t>(count));
        }
        for (std::size_t i = 0; i < variants.size(); ++i)
            report.add({.study = "Sums",
                        .variant = variants[i].name,
                        .x = static_cast<double>(count),
                        .x_name = "terms",
                        .error = std::sqrt(squares[i] / static_cast<double>(orders)),
                        .error_name = "error / ulp",
                        .cost = times[i] / static_cast<double>(count),
                        .cost_name = "time per term / ns"});
    }
}

void study_steps(study::Report& report) {
    for (const Steps& steps : measure_steps()) {
        const auto add = [&](const char* variant, double time) {
            report.add({.study = "Steps through memory",
                        .variant = variant,
                        .x = steps.bytes / 1024,
                        .x_name = "size / KiB",
                        .error = time / steps.array,
                        .error_name = "time / the array's",
                        .cost = time,
                        .cost_name = "time per step / ns"});
        };
        add("array", steps.array);
        add("gathered chain", steps.gathered);
        add("scattered chain", steps.scattered);
    }
}

void study_objects(study::Report& report) {
    for (const Objects& objects :
         {measure_objects<16>(), measure_objects<256>(), measure_objects<4096>()}) {
        const auto add = [&](const char* variant, double calls, double time) {
            report.add({.study = "Stack and heap",
                        .variant = variant,
                        .x = static_cast<double>(objects.bytes),
                        .x_name = "bytes of an object",
                        .error = calls,
                        .error_name = "calls of new per object",
                        .cost = time,
                        .cost_name = "time per object / ns"});
        };
        add("stack", 0, objects.stack);
        add("heap", 1, objects.heap);
        add("heap, 1000 at once", 1.0 / object_count, objects.together);
    }
}

void run_study(study::Report& report) {
    study_sums(report);
    study_steps(report);
    study_objects(report);
}

}  // namespace
}  // namespace toolchain

void (*const app::program_study)(study::Report&) = toolchain::run_study;
