#include <cstring>
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
using Lots = std::array<Lot, pack_size>;

constexpr rt::PackBits all_active = rt::first_bits(pack_size);

void check_pack(const Lots& lots, rt::PackBits active, const char* hint) {
    rt::Vec3Pack normal;
    rt::PlacePack place;
    for (std::size_t i = 0; i < pack_size; ++i) {
        set(normal, i, lots[i].normal);
        place.x[i] = lots[i].place.x;
        place.y[i] = lots[i].place.y;
    }
    rt::Vec3Pack directions;
    try {
        directions = rt::cosine_direction(normal, place, active);
    } catch (const std::domain_error&) {
        INFO("Hint: pass `active` to normalize: then a lane without a direction does not matter");
        FAIL("your code throws because of a lane that is not active");
    }
    bool all_same = true;
    for (std::size_t i = 0; i < pack_size; ++i) {
        if (!(active >> i & 1)) continue;
        const Vec3 expected = rt::cosine_direction(lots[i].normal, lots[i].place);
        const Vec3 actual = get(directions, i);
        if (std::memcmp(&expected, &actual, sizeof expected) == 0) continue;
        all_same = false;
        INFO("lane " << i << " of the pack: the normal " << text(lots[i].normal)
                     << " and the sample point (" << text(lots[i].place.x) << ", "
                     << text(lots[i].place.y) << ") of the unit square");
        INFO(EXPECTED << text(expected) << ", " ACTUAL << text(actual) << ".\nHint: " << hint);
        REQUIRE(text(actual) == text(expected));
    }
    CHECK(all_same);
}

Lot any_lot(rt::Rng& rng) {
    const Real x = rng.uniform(), y = rng.uniform();
    return {any_direction(rng), {x, y}};
}

}  // namespace

TEST_CASE("10.4 each lane equals the result of cosine_direction bit for bit", "[10.4]") {
    rt::Rng rng{104, 1};
    for (int round = 0; round < 20'000; ++round) {
        Lots lots;
        for (Lot& lot : lots) lot = any_lot(rng);
        check_pack(lots, all_active,
                   "use the operations of cosine_direction and orthonormal_basis in the same "
                   "order: a * b * c is (a * b) * c");
    }
}

TEST_CASE("10.4 place.y turns the direction through a full circle", "[10.4]") {
    Lots lots;
    for (int step = 0; step < 1000; ++step) {
        for (std::size_t i = 0; i < pack_size; ++i)
            lots[i].place = {real(0.25), static_cast<Real>(step) / 1000};
        check_pack(lots, all_active, "place.y is the fraction of a full turn");
    }
}

TEST_CASE("10.4 normals along axes and sample points at edges give correct directions",
          "[10.4][hard]") {
    rt::Rng rng{104, 2};
    const Real least = std::numeric_limits<Real>::min();
    const Vec3 axes[]{{1, 0, 0},      {0, 1, 0},     {0, 0, 1},          {-1, 0, 0},
                      {0, -1, 0},     {0, 0, -1},    {1, 0, real(-0.0)}, {0, 1, real(-0.0)},
                      {1, 0, -least}, {0, -1, least}};
    const Real last = 1 - rt::epsilon / 2;
    for (int round = 0; round < 20'000; ++round) {
        Lots lots;
        for (Lot& lot : lots) {
            lot = any_lot(rng);
            if (rng() % 2 == 0) lot.normal = axes[rng() % std::size(axes)];
            if (rng() % 3 == 0) lot.place.x = rng() % 2 == 0 ? 0 : last;
            if (rng() % 3 == 0) lot.place.y = rng() % 2 == 0 ? 0 : last;
            if (rng() % 8 == 0) lot.place.x = rt::epsilon / 2;
            if (rng() % 8 == 0) lot.place.y = static_cast<Real>(rng() % 8) / 8;
        }
        check_pack(lots, all_active, "take the sign of w.z, even if w.z is -0");
    }
}

TEST_CASE("10.4 values in unused lanes do no harm", "[10.4][hard]") {
    rt::Rng rng{104, 3};
    const Real nothing = std::numeric_limits<Real>::quiet_NaN();
    for (int round = 0; round < 3000; ++round) {
        Lots lots;
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
        check_pack(lots, active, "only lanes whose bit in `active` is set need a result");
    }
}

TEST_CASE("10.4 any of the lanes may be active", "[10.4][hard]") {
    rt::Rng rng{104, 4};
    const Real nothing = std::numeric_limits<Real>::quiet_NaN();
    for (std::size_t k = 0; k <= pack_size; ++k)
        for (int round = 0; round < 100; ++round) {
            Lots lots;
            for (std::size_t i = 0; i < pack_size; ++i)
                lots[i] = i < k ? any_lot(rng) : Lot{{0, 0, nothing}, {nothing, nothing}};
            check_pack(lots, rt::first_bits(k), "only some of the lanes may be in use");
            if (k == pack_size) continue;
            lots.fill({{}, {nothing, 0}});
            lots[k] = any_lot(rng);
            check_pack(lots, rt::PackBits{1} << k, "only some of the lanes may be in use");
        }
}
