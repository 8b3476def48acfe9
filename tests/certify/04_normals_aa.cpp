// Lambert's falloff: computed, and as the bounces of a matte surface show it.
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/lambert.hpp>

#include "certificate.hpp"

namespace {

using namespace certify;

void falloff(Certificate& certificate) {
    rt::Rng rng{1, 4};
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double angle = static_cast<double>(rng.uniform(0, rt::pi));
        const double around = static_cast<double>(rng.uniform(0, 2 * rt::pi));
        const Vec3 normal{0, 1, 0};
        const Vec3 light{static_cast<Real>(std::sin(angle) * std::cos(around)),
                         static_cast<Real>(std::cos(angle)),
                         static_cast<Real>(std::sin(angle) * std::sin(around))};
        const double exact = std::max(0.0, std::cos(angle));
        worst = std::max(worst, std::abs(static_cast<double>(rt::lambert(normal, light)) - exact));
    }
    certificate.at_most("04.2", "Lambert against the cosine, 0 to 180 degrees", worst / epsilon, 4,
                        "epsilon");
}

// With a density of cos / pi, cos^2 of the angle to the normal is spread evenly over [0, 1].
void bounces(Certificate& certificate) {
    rt::Rng rng{2, 4};
    constexpr int count = 1'000'000, bins = 50;
    const Vec3 normal = checkpoint::any_direction(rng);
    std::vector<long> seen(bins);
    for (int i = 0; i < count; ++i) {
        const Real cosine = rt::dot(rt::cosine_direction(normal, rt::random_place(rng)), normal);
        const int bin = static_cast<int>(static_cast<double>(cosine * std::abs(cosine)) * bins);
        ++seen[static_cast<std::size_t>(std::clamp(bin, 0, bins - 1))];
    }
    double worst = 0;
    for (const long n : seen)
        worst = std::max(worst, std::abs(static_cast<double>(n) * bins / count - 1));
    // Six standard deviations of a bin: 6 sqrt(bins / count).
    certificate.at_most("04.3", "a million bounces against the cosine, worst of 50 bins",
                        100 * worst, 100 * 6 * std::sqrt(double(bins) / count), "%");
}

}  // namespace

int main() {
    return certify::certify(falloff, bounces);
}
