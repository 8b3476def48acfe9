#include <rt/directions.hpp>
#include <rt/matte_pack.hpp>

#include "random_inputs.hpp"
#include "statistics.hpp"

using namespace checkpoint;
using rt::pack_size;
using rt::Vec2;

namespace {

struct Lot {
    Vec3 normal{0, 0, 1};
    Vec2 place;
};

void check_pack(const std::array<Lot, pack_size>& lots, rt::PackBits active, const char* hint) {
    rt::Vec3Pack normal;
    rt::PlacePack place;
    for (std::size_t i = 0; i < pack_size; ++i) {
        set(normal, i, lots[i].normal);
        place.x[i] = lots[i].place.x;
        place.y[i] = lots[i].place.y;
    }
    const rt::Vec3Pack directions = rt::cosine_direction(normal, place, active);
    for (std::size_t i = 0; i < pack_size; ++i) {
        if (!(active >> i & 1)) continue;
        const Vec3 expected = rt::cosine_direction(lots[i].normal, lots[i].place);
        const Vec3 actual = get(directions, i);
        if (expected == actual) continue;
        INFO("place " << i << " of the pack: the normal " << text(lots[i].normal)
                      << " and the place (" << text(lots[i].place.x) << ", "
                      << text(lots[i].place.y) << ")");
        INFO("Hint: " << hint);
        REQUIRE(text(actual) == text(expected));
    }
}

Lot any_lot(rt::Rng& rng) {
    const Real x = rng.uniform(), y = rng.uniform();
    return {any_direction(rng), {x, y}};
}

}  // namespace

TEST_CASE("10.4 the bits of one direction at a time", "[10.4]") {
    rt::Rng rng{104, 1};
    for (int round = 0; round < 20'000; ++round) {
        std::array<Lot, pack_size> lots;
        for (Lot& lot : lots) lot = any_lot(rng);
        check_pack(lots, rt::first_bits(pack_size),
                   "the operations of cosine_direction and orthonormal_basis, in their order: "
                   "a * b * c is (a * b) * c");
    }
}

TEST_CASE("10.4 the circle goes all the way around", "[10.4]") {
    std::array<Lot, pack_size> lots;
    for (int step = 0; step < 1000; ++step) {
        for (std::size_t i = 0; i < pack_size; ++i)
            lots[i].place = {real(0.25), static_cast<Real>(step) / 1000};
        check_pack(lots, rt::first_bits(pack_size), "the angle is 2 pi times the place's y");
    }
}

TEST_CASE("10.4 normals along the axes and places at the edge", "[10.4][hard]") {
    rt::Rng rng{104, 2};
    const Vec3 axes[]{{1, 0, 0},  {0, 1, 0},  {0, 0, 1},          {-1, 0, 0},
                      {0, -1, 0}, {0, 0, -1}, {1, 0, real(-0.0)}, {0, 1, real(-0.0)}};
    const Real last = 1 - rt::epsilon / 2;
    for (int round = 0; round < 20'000; ++round) {
        std::array<Lot, pack_size> lots;
        for (Lot& lot : lots) {
            lot = any_lot(rng);
            if (rng() % 2 == 0) lot.normal = axes[rng() % 8];
            if (rng() % 3 == 0) lot.place.x = rng() % 2 == 0 ? 0 : last;
            if (rng() % 3 == 0) lot.place.y = rng() % 2 == 0 ? 0 : last;
            if (rng() % 8 == 0) lot.place.x = rt::epsilon / 2;
        }
        check_pack(lots, rt::first_bits(pack_size), "the sign is that of w.z, also of -0");
    }
}

TEST_CASE("10.4 what unused places hold does no harm", "[10.4][hard]") {
    rt::Rng rng{104, 3};
    const Real nothing = std::numeric_limits<Real>::quiet_NaN();
    for (int round = 0; round < 3000; ++round) {
        std::array<Lot, pack_size> lots;
        rt::PackBits active = 0;
        for (std::size_t i = 0; i < pack_size; ++i) {
            lots[i] = any_lot(rng);
            switch (rng() % 4) {
                case 0:
                    lots[i].normal = {};
                    break;
                case 1:
                    lots[i] = {{nothing, nothing, nothing}, {nothing, 2}};
                    break;
                default:
                    active |= rt::PackBits{1} << i;
            }
        }
        try {
            check_pack(lots, active, "normalize the active ones alone");
        } catch (const std::domain_error&) {
            INFO("Hint: give `active` to normalize: what has no direction does not matter then");
            FAIL("it throws because of a place of the pack that is not active");
        }
    }
}
