#include <rt/filter_list.hpp>
#include <rt/rng.hpp>
#include <vector>

#include "checkpoint.hpp"

namespace {

std::string text(const std::vector<std::uint32_t>& list) {
    std::string all;
    for (std::size_t i = 0; i < list.size() && i < 12; ++i) all += ' ' + std::to_string(list[i]);
    return '{' + all + (list.size() > 12 ? " ... }" : " }");
}

// What it does with a list, beside what it should do.
void check_filter(const std::vector<std::uint32_t>& list, const std::vector<std::uint8_t>& masks,
                  unsigned bit) {
    std::vector<std::uint32_t> expected;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (masks[i] & 1u << bit) expected.push_back(list[i]);
    // Two numbers behind the room that it has must stay as they are.
    constexpr std::uint32_t untouched = 0xdeadbeef;
    std::vector<std::uint32_t> to(list.size() + 2, untouched);
    const std::vector<std::uint32_t> list_before = list;
    const std::vector<std::uint8_t> masks_before = masks;
    const std::size_t count = rt::filter_list(list, masks.data(), bit, to.data());
    INFO("a list of " << list.size() << " paths, " << text(list) << ", bit " << bit);
    {
        INFO("Hint: the result is how many paths have the bit");
        REQUIRE(count == expected.size());
    }
    {
        INFO("Hint: it must not write beyond the length of the list");
        REQUIRE(to[list.size()] == untouched);
        REQUIRE(to[list.size() + 1] == untouched);
    }
    to.resize(count);
    INFO("expected " << text(expected) << ", but yours gives " << text(to));
    {
        INFO(
            "Hint: the paths, not their places in the list, in the same order; masks[i] belongs to "
            "list[i]");
        REQUIRE(to == expected);
    }
    REQUIRE(list == list_before);
    REQUIRE(masks == masks_before);
}

}  // namespace

TEST_CASE("10.1 the paths whose mask has the bit in their order", "[10.1]") {
    check_filter({7, 3, 9, 4}, {0b0010, 0b0001, 0b0110, 0b0011}, 1);
    check_filter({7, 3, 9, 4}, {0b0010, 0b0001, 0b0110, 0b0011}, 0);
    check_filter({5}, {0b1000}, 3);
    check_filter({5}, {0b1000}, 2);
}

TEST_CASE("10.1 every bit of every list", "[10.1]") {
    rt::Rng rng{101, 1};
    for (int round = 0; round < 3000; ++round) {
        const std::size_t size = rng() % 70;
        std::vector<std::uint32_t> list(size);
        std::vector<std::uint8_t> masks(size);
        // Few bits, many, or any.
        const unsigned kind = rng() % 3;
        for (std::size_t i = 0; i < size; ++i) {
            list[i] = rng();
            const std::uint32_t a = rng(), b = rng();
            masks[i] = static_cast<std::uint8_t>(kind == 0 ? a & b : kind == 1 ? a | b : a);
        }
        for (unsigned bit = 0; bit < 8; ++bit) check_filter(list, masks, bit);
    }
}

TEST_CASE("10.1 lists without a path and lists of which all or none go on", "[10.1][hard]") {
    check_filter({}, {}, 0);
    for (const std::size_t size : {1, 2, 255, 256, 257, 5000}) {
        std::vector<std::uint32_t> list(size);
        for (std::size_t i = 0; i < size; ++i)
            list[i] = static_cast<std::uint32_t>(4'000'000'000 - 7 * i);
        for (unsigned bit = 0; bit < 8; ++bit) {
            check_filter(
                list, std::vector<std::uint8_t>(size, static_cast<std::uint8_t>(1u << bit)), bit);
            check_filter(list,
                         std::vector<std::uint8_t>(size, static_cast<std::uint8_t>(~(1u << bit))),
                         bit);
            check_filter(list, std::vector<std::uint8_t>(size, 0xff), bit);
        }
    }
}
