#include <rt/canvas.hpp>
#include <type_traits>
#include <vector>

#include "checkpoint.hpp"
#include "watched.hpp"

using namespace checkpoint;
using Canvas = rt::Canvas<WatchedPixel>;

namespace {

// Pixel (x, y) is 10 y + x.
Canvas numbered(int width, int height) {
    Canvas canvas{width, height, WatchedPixel{0}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) canvas.at(x, y) = WatchedPixel{10 * y + x};
    return canvas;
}

bool is_numbered(const Canvas& canvas, int width, int height) {
    if (canvas.width() != width || canvas.height() != height) return false;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (canvas.at(x, y).value() != 10 * y + x) return false;
    return true;
}

// At the end of a test case, when all canvases are gone.
void check_memory() {
    {
        INFO("pixels that were never destroyed: "
             << Watch::live_objects() << ", in " << Watch::live_blocks()
             << " pieces of memory that were never released.\nHint: delete[] pixels_ in the "
                "destructor, and no pointer to pixels may be overwritten while it owns them");
        CHECK(Watch::live_objects() == 0);
        CHECK(Watch::live_blocks() == 0);
    }
    {
        INFO("released twice: "
             << Watch::released_twice
             << ".\nHint: two canvases had the same pixels_, and each released it");
        CHECK(Watch::released_twice == 0);
    }
    INFO("uses of pixels that were gone: " << Watch::dead_uses
                                           << ".\nHint: a pointer or a reference outlived them");
    CHECK(Watch::dead_uses == 0);
}

}  // namespace

TEST_CASE("00.2 a new canvas has its size and its color", "[00.2]") {
    const Watch watch;
    Canvas canvas{3, 2, WatchedPixel{7}};
    INFO(
        "Hint: remember width and height, make size() pixels with new Pixel[size()], and give "
        "each the color. `int width_ = width;` would make another variable: no type before the "
        "name of a member");
    CHECK(canvas.width() == 3);
    CHECK(canvas.height() == 2);
    REQUIRE((canvas.begin() != nullptr));
    for (const WatchedPixel& pixel : canvas) CHECK(pixel.value() == 7);
    CHECK(Watch::dead_uses == 0);
}

TEST_CASE("00.2 the pixels are released with the canvas", "[00.2]") {
    const Watch watch;
    { const Canvas canvas{3, 2, WatchedPixel{7}}; }
    check_memory();
}

TEST_CASE("00.2 a copy has pixels of its own", "[00.2]") {
    const Watch watch;
    {
        const Canvas original = numbered(3, 2);
        Canvas copy = original;
        CHECK(is_numbered(copy, 3, 2));
        INFO(
            "both canvases have the same pixels.\nHint: a copied pointer is not a copied picture: "
            "new pixels, then copy the colors");
        CHECK((copy.begin() != original.begin()));
        copy.at(1, 1) = WatchedPixel{99};
        CHECK(original.at(1, 1).value() == 11);
    }
    check_memory();
}

TEST_CASE("00.2 a move takes the pixels over", "[00.2]") {
    const Watch watch;
    {
        Canvas original = numbered(3, 2);
        const WatchedPixel* const pixels = original.begin();
        const int made = Watch::made;
        const Canvas taken = std::move(original);
        INFO("pixels made or copied by the move: "
             << Watch::made - made
             << ".\nHint: take over the pointer, and set the other one's to nullptr");
        CHECK(Watch::made == made);
        CHECK((taken.begin() == pixels));
        CHECK(is_numbered(taken, 3, 2));
        INFO("a canvas that was moved from must be empty");
        CHECK(original.width() == 0);
        CHECK(original.height() == 0);
        CHECK((original.begin() == nullptr));
    }
    check_memory();
}

TEST_CASE("00.2 assignment copies or moves and releases what was there", "[00.2]") {
    const Watch watch;
    {
        Canvas a{4, 4, WatchedPixel{1}}, b = numbered(3, 2);
        a = b;
        CHECK(is_numbered(a, 3, 2));
        CHECK(is_numbered(b, 3, 2));
        CHECK((a.begin() != b.begin()));
        a.at(0, 0) = WatchedPixel{99};
        const int made = Watch::made;
        const WatchedPixel* const pixels = b.begin();
        a = std::move(b);
        INFO("a = std::move(b) made " << Watch::made - made << " pixels, and should make none");
        CHECK(Watch::made == made);
        CHECK((a.begin() == pixels));
        CHECK(is_numbered(a, 3, 2));
    }
    check_memory();
}

TEST_CASE("00.2 flipped swaps top and bottom", "[00.2]") {
    const Watch watch;
    {
        const Canvas canvas = numbered(3, 2);
        const Canvas turned = rt::flipped(canvas);
        REQUIRE(turned.width() == 3);
        REQUIRE(turned.height() == 2);
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x) {
                INFO("pixel (" << x << ", " << y << ")\nHint: swap row y with row height - 1 - y, "
                               << "and only for the upper half, or all rows are swapped twice");
                CHECK(turned.at(x, y).value() == 10 * (1 - y) + x);
            }
        INFO("flipped must not change the canvas that it was given a copy of");
        CHECK(is_numbered(canvas, 3, 2));
    }
    check_memory();
}

TEST_CASE("00.2 a canvas that is moved into flipped comes out again", "[00.2]") {
    const Watch watch;
    {
        Canvas canvas = numbered(4, 1);  // one row: nothing is to be swapped
        const WatchedPixel* const pixels = canvas.begin();
        const int made = Watch::made;
        const Canvas turned = rt::flipped(std::move(canvas));
        INFO("pixels that were made on the way: "
             << Watch::made - made
             << ".\nHint: take the canvas as a value, flip that, and return it by its name");
        CHECK(Watch::made == made);
        CHECK((turned.begin() == pixels));
    }
    check_memory();
}

TEST_CASE("00.2 largest is a reference to the pixel itself", "[00.2]") {
    const Watch watch;
    {
        Canvas canvas = numbered(3, 2);
        canvas.at(1, 0) = WatchedPixel{55};
        const WatchedPixel& found = rt::largest(canvas);
        INFO(
            "Hint: take the canvas by const reference. A canvas that was copied into the function "
            "is gone at its end, and a reference to its pixel leads nowhere");
        CHECK(Watch::dead_uses == 0);
        CHECK((&found == &canvas.at(1, 0)));
        CHECK(found.value() == 55);
        CHECK(Watch::dead_uses == 0);
    }
    check_memory();
}

TEST_CASE("00.2 of several largest pixels the first is found", "[00.2][hard]") {
    const Watch watch;
    Canvas canvas{3, 3, WatchedPixel{-5}};
    // Catch2 would print addresses, which tell a person nothing.
    const auto check_found = [&](int x, int y, const char* hint) {
        const WatchedPixel* const found = &rt::largest(canvas);
        INFO("pixel (" << x << ", " << y << ") was to be found.\nHint: " << hint);
        const bool right_one = found == &canvas.at(x, y);
        CHECK(right_one);
    };
    check_found(0, 0,
                "all are equal: the first one stays unless another is larger, so < and not <=. "
                "And start with the first pixel itself, not with 0: all are below 0");
    canvas.at(2, 1) = canvas.at(0, 2) = WatchedPixel{-4};
    check_found(2, 1, "the first of the largest ones: replace it only by one that is larger");
}

TEST_CASE("00.2 a canvas may be assigned to itself", "[00.2][hard]") {
    const Watch watch;
    {
        Canvas canvas = numbered(3, 2);
        const Canvas& same = canvas;
        canvas = same;
        INFO("Hint: release the old pixels last, when the new ones are there already");
        CHECK(Watch::dead_uses == 0);
        CHECK(is_numbered(canvas, 3, 2));
    }
    check_memory();
}

TEST_CASE("00.2 a vector of canvases grows without copies", "[00.2][hard]") {
    const Watch watch;
    {
        std::vector<Canvas> canvases;
        for (int i = 0; i < 9; ++i) {
            Canvas canvas = numbered(2, 2);
            const int made = Watch::made;
            canvases.push_back(std::move(canvas));
            INFO("pixels made when canvas number "
                 << i << " moved in: " << Watch::made - made
                 << ".\nHint: a vector that grows moves its elements only when that is noexcept: "
                    "Canvas(Canvas&& other) noexcept");
            CHECK(Watch::made == made);
        }
        for (const Canvas& canvas : canvases) CHECK(is_numbered(canvas, 2, 2));
    }
    check_memory();
}

TEST_CASE("00.2 a canvas that was moved from can be used again", "[00.2][hard]") {
    const Watch watch;
    {
        Canvas canvas = numbered(3, 2);
        const Canvas taken = std::move(canvas);
        const Canvas empty_copy = canvas;
        CHECK(empty_copy.size() == 0);
        canvas = taken;
        CHECK(is_numbered(canvas, 3, 2));
        CHECK(is_numbered(taken, 3, 2));
    }
    check_memory();
}

TEST_CASE("00.2 sides below 1 are refused and nothing is lost", "[00.2][hard]") {
    const Watch watch;
    { const Canvas one{1, 1, WatchedPixel{1}}; }
    for (const auto& [width, height] : {std::pair{0, 5}, std::pair{5, 0}, std::pair{-1, 5},
                                        std::pair{5, -1}, std::pair{-2, -3}}) {
        bool refused = false;
        try {
            const Canvas canvas{width, height, WatchedPixel{1}};
        } catch (const std::invalid_argument&) {
            refused = true;
        } catch (const std::bad_alloc&) {  // new was asked for an absurd number of them
        }
        INFO("sides of " << width << " x " << height
                         << " were not refused.\nHint: throw std::invalid_argument, before "
                            "anything else, when width < 1 or (||) height < 1");
        CHECK(refused);
    }
    INFO(
        "Hint: throw before new. An object whose constructor throws is never destroyed, and what "
        "it "
        "held is lost");
    check_memory();
}

TEST_CASE("00.2 odd heights and long rows are flipped", "[00.2][hard]") {
    const Watch watch;
    for (const auto& [width, height] :
         {std::pair{1, 1}, std::pair{1, 5}, std::pair{9, 3}, std::pair{2, 4}, std::pair{7, 1}}) {
        const Canvas canvas = numbered(width, height);
        CHECK(is_numbered(rt::flipped(rt::flipped(canvas)), width, height));
        const Canvas turned = rt::flipped(canvas);
        INFO(width << " x " << height << "\nHint: the middle row of an odd number stays");
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                CHECK(turned.at(x, y).value() == canvas.at(x, height - 1 - y).value());
    }
}
