#include <rt/filter_list.hpp>
#include <rt/rng.hpp>
#include <vector>

#include "checkpoint.hpp"
#include "fenced.hpp"

using checkpoint::Fenced;

namespace {

using Paths = std::vector<std::uint32_t>;
using Masks = std::vector<std::uint8_t>;

constexpr std::uint32_t unwritten = 0xdeadbeef;  // no list has this path

// Up to twelve of the paths, from this index on.
std::string text(const Paths& list, std::size_t from = 0) {
    std::string all = from > 0 ? " ..." : "";
    for (std::size_t i = from; i < list.size() && i < from + 12; ++i)
        all += list[i] == unwritten ? " (not written)" : ' ' + std::to_string(list[i]);
    return '{' + all + (list.size() > from + 12 ? " ... }" : " }");
}
std::string binary(const Masks& masks) {
    std::string all;
    for (std::size_t i = 0; i < masks.size() && i < 12; ++i) {
        all += " 0b";
        for (unsigned bit = 8; bit-- > 0;) all += masks[i] >> bit & 1 ? '1' : '0';
    }
    return '{' + all + (masks.size() > 12 ? " ... }" : " }");
}

// What filter_list makes of a list. `beside` is the value before and after the masks.
void check_filter(const Paths& list, const Masks& masks, unsigned bit, std::uint8_t beside) {
    Paths expected;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (masks[i] & 1u << bit) expected.push_back(list[i]);
    Fenced<std::uint32_t> from{list, 123'456'789};
    Fenced<std::uint32_t> to{list.size(), unwritten, unwritten, 3 * list.size() + 64};
    Fenced<std::uint8_t> marks{masks, beside};
    const std::size_t count = rt::filter_list(from.span(), marks.data(), bit, to.data());
    const Paths actual(to.data(), to.data() + std::min(count, list.size()));
    const bool is_right = count == expected.size() && actual == expected && to.stands();
    if (!is_right) {
        INFO("a list of " << list.size() << " paths " << text(list) << " with the masks "
                          << binary(masks) << ", bit " << bit);
        const auto same = static_cast<std::size_t>(
            std::mismatch(actual.begin(), actual.end(), expected.begin(), expected.end()).first -
            actual.begin());
        const std::size_t first = same < 12 ? 0 : same;
        INFO(EXPECTED << expected.size() << " paths " << text(expected, first) << ", " ACTUAL
                      << count << ' ' << text(actual, first));
        {
            INFO(
                "Hint: `to` has room for as many paths as the list has, and no more: do not write "
                "to the memory before or after it");
            REQUIRE(to.stands());
        }
        {
            INFO("Hint: the result is how many paths have the bit: add 0 or 1 for each");
            REQUIRE(count == expected.size());
        }
        INFO(
            "Hint: copy the paths list[i], not their indices i, in the same order; masks[i] "
            "belongs to list[i]");
        REQUIRE(text(actual, first) == text(expected, first));
    }
    CHECK(is_right);
}
void check_filter(const Paths& list, const Masks& masks, unsigned bit) {
    check_filter(list, masks, bit, 0);
    check_filter(list, masks, bit, 0xff);
}

// Some masks with few bits, some with many, some with any.
Masks some_masks(rt::Rng& rng, std::size_t size) {
    const unsigned kind = rng() % 3;
    Masks masks(size);
    for (std::uint8_t& mask : masks) {
        const std::uint32_t a = rng(), b = rng();
        mask = static_cast<std::uint8_t>(kind == 0 ? a & b : kind == 1 ? a | b : a);
    }
    return masks;
}

}  // namespace

TEST_CASE("10.1 the paths whose mask has the bit keep their order", "[10.1]") {
    check_filter({7, 3, 9, 4}, {0b0010, 0b0001, 0b0110, 0b0011}, 1);
    check_filter({7, 3, 9, 4}, {0b0010, 0b0001, 0b0110, 0b0011}, 0);
    check_filter({5}, {0b1000}, 3);
    check_filter({5, 6}, {0b0100, 0b1000}, 3);
}

TEST_CASE("10.1 lists are filtered correctly by every bit", "[10.1]") {
    rt::Rng rng{101, 1};
    for (std::size_t size = 1; size < 140; ++size)
        for (int round = 0; round < 4; ++round) {
            // Any numbers, or the first few: 0, 1, 2 ...
            const std::uint32_t most = round % 2 ? 0xffff'ffff : static_cast<std::uint32_t>(size);
            Paths list(size);
            for (std::uint32_t& path : list) path = rng() % most;
            const Masks masks = some_masks(rng, size);
            for (unsigned bit = 0; bit < 8; ++bit) check_filter(list, masks, bit);
        }
}

TEST_CASE("10.1 empty lists and lists where all or no paths go on are filtered", "[10.1][hard]") {
    check_filter({}, {}, 0);
    check_filter({}, {}, 7);
    for (const std::size_t size : {1, 2, 3, 8, 255, 256, 257, 5000, 65'537}) {
        Paths list(size);
        for (std::size_t i = 0; i < size; ++i)
            list[i] = static_cast<std::uint32_t>(4'294'967'295 - 7 * i);
        for (unsigned bit = 0; bit < 8; ++bit) {
            const auto only = static_cast<std::uint8_t>(1u << bit);
            check_filter(list, Masks(size, only), bit);
            check_filter(list, Masks(size, static_cast<std::uint8_t>(~only)), bit);
            check_filter(list, Masks(size, 0xff), bit);
            check_filter(list, Masks(size, 0), bit);
        }
    }
}

TEST_CASE("10.1 a list of a hundred thousand paths is filtered correctly", "[10.1][hard]") {
    rt::Rng rng{101, 2};
    Paths list(100'000);
    for (std::uint32_t& path : list) path = rng();
    const Masks masks = some_masks(rng, list.size());
    for (unsigned bit = 0; bit < 8; ++bit) check_filter(list, masks, bit);
}
