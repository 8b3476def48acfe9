// Metal in a white furnace; Snell, total reflection, Schlick and Fresnel.
#include <rt/cross.hpp>
#include <rt/dielectric.hpp>
#include <rt/dot.hpp>
#include <rt/fresnel.hpp>
#include <rt/length.hpp>
#include <rt/metal.hpp>
#include <rt/refract.hpp>

#include "certificate.hpp"

namespace {

using namespace certify;

// Under light from everywhere, white metal is as bright as the light: no path may end or go below.
void white_furnace(Certificate& certificate) {
    rt::Rng rng{1, 5};
    rt::Hit hit;
    hit.normal = {0, 1, 0};
    long lost = 0, count = 0;
    for (const Real fuzz : {Real(0), Real(0.1), Real(0.4), Real(1)})
        for (int i = 0; i < 50'000; ++i) {
            // Half of them along the rim.
            const Real height = i % 2 ? rng.uniform() : Real(0.02) * rng.uniform();
            const Real side = std::sqrt(1 - height * height);
            const auto bounce =
                rt::scatter(rt::Metal{{1, 1, 1}, fuzz}, Vec3{side, -height, 0}, hit, rng);
            lost +=
                !bounce || !(bounce->direction.y >= 0) || bounce->attenuation != rt::Color{1, 1, 1};
            ++count;
        }
    certificate.at_most("05.2", "white furnace: light that metal loses, fuzz 0 to 1",
                        100.0 * static_cast<double>(lost) / static_cast<double>(count), 0, "%");
}

void snell(Certificate& certificate) {
    rt::Rng rng{2, 5};
    double worst = 0;
    long wrong = 0, total = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 normal = checkpoint::any_direction(rng);
        Vec3 incoming = checkpoint::any_direction(rng);
        if (rt::dot(incoming, normal) > 0) incoming = -incoming;
        const Real eta = checkpoint::any_size(rng, Real(-0.4), Real(0.4));
        const double sine = static_cast<double>(rt::length(rt::cross(normal, incoming)));
        const double beyond = static_cast<double>(eta) * sine;
        const auto refracted = rt::refract(incoming, normal, eta);
        // Within rounding of the critical angle either answer is right.
        if (std::abs(beyond - 1) > 1e-13) {
            wrong += refracted.has_value() == (beyond > 1);
            total += beyond > 1;
        }
        if (!refracted) continue;
        const double computed = static_cast<double>(rt::length(rt::cross(normal, *refracted)));
        worst = std::max(worst, std::abs(computed - beyond) / epsilon);
        wrong += rt::dot(*refracted, normal) > 0;
    }
    certificate.at_most("05.3", "Snell: eta sin a against the refracted sine", worst, 16,
                        "epsilon");
    certificate.at_most("05.3", "total reflection decided wrongly, of 100,000 rays",
                        static_cast<double>(wrong), 0, "");
    certificate.shows("05.3", "rays among them that are reflected totally",
                      static_cast<double>(total), "");
}

// The exact share from Fresnel's equations, with more digits than a Real has.
long double fresnel(long double cosine, long double eta) {
    const long double squared = 1 - eta * eta * (1 - cosine) * (1 + cosine);
    if (squared < 0) return 1;
    const long double beyond = std::sqrt(squared);
    const long double s = (eta * cosine - beyond) / (eta * cosine + beyond);
    const long double p = (cosine - eta * beyond) / (cosine + eta * beyond);
    return (s * s + p * p) / 2;
}

void reflectance(Certificate& certificate) {
    double exact_error = 0, schlick_error = 0, apart = 0;
    for (int i = 1; i <= 1000; ++i)
        for (const long double eta : {1 / 1.5L, 1.5L, 1 / 2.4L, 1.1L}) {
            const long double cosine = i / 1000.0L;
            const auto c = static_cast<Real>(cosine);
            const auto e = static_cast<Real>(eta);
            const long double exact = fresnel(cosine, eta);
            exact_error = std::max(
                exact_error, static_cast<double>(std::abs(
                                 static_cast<long double>(rt::fresnel_reflectance(c, e)) - exact)));
            // On the thinner side: from inside the cosine is the refracted one.
            const long double squared = 1 - eta * eta * (1 - cosine) * (1 + cosine);
            const long double thin = eta > 1 ? (squared > 0 ? std::sqrt(squared) : 0.0L) : cosine;
            const long double r = (1 - eta) / (1 + eta), x = 1 - thin;
            const long double schlick = r * r + (1 - r * r) * x * x * x * x * x;
            const auto computed = static_cast<long double>(rt::schlick_reflectance(c, e));
            schlick_error =
                std::max(schlick_error, static_cast<double>(std::abs(computed - schlick)));
            if (eta == 1 / 1.5L)
                apart = std::max(apart, static_cast<double>(std::abs(computed - exact)));
        }
    // Next to the critical angle a rounding of the cosine grows by a square root.
    certificate.at_most("05.4", "Fresnel's equations, largest error", exact_error, 1e-12, "");
    certificate.at_most("05.4", "Schlick's formula on the thinner side, largest error",
                        schlick_error, 1e-12, "");
    certificate.shows("05.4", "Schlick against Fresnel for glass of 1.5, largest difference", apart,
                      "");
}

// Glass neither absorbs nor creates light, and lets through as much as Fresnel says.
void glass(Certificate& certificate) {
    rt::Rng rng{3, 5};
    rt::Hit hit;
    hit.normal = {0, 1, 0};
    double worst = 0;
    constexpr int count = 200'000;
    for (const double cosine : {1.0, 0.6, 0.2}) {
        long reflected = 0, lost = 0;
        const auto c = static_cast<Real>(cosine);
        for (int i = 0; i < count; ++i) {
            const auto bounce =
                rt::scatter(rt::Dielectric{Real(1.5)}, Vec3{std::sqrt(1 - c * c), -c, 0}, hit, rng);
            lost += !bounce || bounce->attenuation != rt::Color{1, 1, 1};
            reflected += bounce && bounce->direction.y > 0;
        }
        const double share = static_cast<double>(reflected) / count;
        worst = std::max(worst, std::abs(share - static_cast<double>(fresnel(cosine, 1 / 1.5L))));
        worst = std::max(worst, static_cast<double>(lost));
    }
    // Six standard deviations of a share of one half, at most.
    certificate.at_most("05.5", "share that glass reflects against Fresnel's", worst,
                        3 / std::sqrt(double(count)), "");
}

}  // namespace

int main() {
    return certify::certify(white_furnace, snell, reflectance, glass);
}
