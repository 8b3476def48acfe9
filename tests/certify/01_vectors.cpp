// Vectors, against arithmetic with twice the digits.
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <study/double_double.hpp>

#include "certificate.hpp"

namespace {

using namespace certify;
using study::DoubleDouble;

constexpr int vectors = 100'000;

Vec3 any_vector(rt::Rng& rng) {
    return checkpoint::any_size(rng, -3, 3) * checkpoint::any_direction(rng);
}

// A sum of n products has n roundings on its longest way, of half an epsilon each; they are
// relative to the sum without signs. Source: Higham, "Accuracy and Stability", section 3.1.
void dot_product(Certificate& certificate) {
    rt::Rng rng{1, 1};
    double worst = 0;
    for (int i = 0; i < vectors; ++i) {
        const Vec3 a = any_vector(rng), b = any_vector(rng);
        const auto product = [](Real x, Real y) { return DoubleDouble(x) * DoubleDouble(y); };
        const DoubleDouble exact = product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z);
        const double size = std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
        const double error = (DoubleDouble(rt::dot(a, b)) - exact).high;
        worst = std::max(worst, std::abs(error) / (size * epsilon));
    }
    certificate.at_most("01.2", "dot product, error against the sum of |a b|", worst, 1.5,
                        "epsilon");
}

// Lengths from 10^-exponent to 10^exponent: if it is 200, their squares do not fit.
void unit_vectors(Certificate& certificate, const char* exercise, int exponent) {
    rt::Rng rng{2, 1};
    double worst_direction = 0, worst_length = 0;
    for (int i = 0; i < vectors; ++i) {
        const auto size = static_cast<Real>(exponent);
        const Vec3 v = checkpoint::any_size(rng, -size, size) * checkpoint::any_direction(rng);
        const Real scale = std::abs(v.x) > std::abs(v.y) ? std::abs(v.x) : std::abs(v.y);
        const auto part = [&](Real x) { return DoubleDouble(x) / DoubleDouble(scale); };
        const DoubleDouble x = part(v.x), y = part(v.y), z = part(v.z);
        const DoubleDouble length = sqrt(x * x + y * y + z * z);
        const Vec3 n = rt::normalize(v);
        const auto error = [&](Real computed, DoubleDouble exact) {
            return std::abs((DoubleDouble(computed) - exact / length).high) / epsilon;
        };
        worst_direction = std::max({worst_direction, error(n.x, x), error(n.y, y), error(n.z, z)});
        const double ratio =
            ((DoubleDouble(rt::length(v)) / DoubleDouble(scale)) / length - DoubleDouble(1)).high;
        worst_length = std::max(worst_length, std::abs(ratio) / epsilon);
    }
    const std::string range =
        ", lengths from 1e-" + std::to_string(exponent) + " to 1e" + std::to_string(exponent);
    certificate.at_most(exercise, ("length" + range).c_str(), worst_length, 4, "epsilon");
    certificate.at_most(exercise, ("normalize" + range).c_str(), worst_direction, 4, "epsilon");
}

void bases(Certificate& certificate) {
    rt::Rng rng{3, 1};
    double worst = 0;
    for (int i = 0; i < vectors; ++i) {
        const rt::Basis b = rt::orthonormal_basis(checkpoint::any_direction(rng));
        // Right-handed and at right angles: each is the product of the other two.
        for (const Vec3 off :
             {rt::cross(b.u, b.v) - b.w, rt::cross(b.v, b.w) - b.u, rt::cross(b.w, b.u) - b.v})
            worst = std::max(worst, largest_component(off) / epsilon);
    }
    certificate.at_most("01.8", "orthonormal basis, right angles and handedness", worst, 8,
                        "epsilon");
}

}  // namespace

int main() {
    return certify::certify(
        dot_product, [](auto& certificate) { unit_vectors(certificate, "01.4", 3); },
        [](auto& certificate) { unit_vectors(certificate, "01.4*", 200); }, bases);
}
