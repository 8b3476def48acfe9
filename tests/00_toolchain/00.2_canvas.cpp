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

// Says what is wrong with a canvas that ought to be numbered.
void check_numbered(const char* what, const Canvas& canvas, int width, int height,
                    const char* hint) {
    const bool as_expected = is_numbered(canvas, width, height);
    INFO(what << " has " << canvas.width() << " x " << canvas.height() << " pixels, expected "
              << width << " x " << height
              << (canvas.width() == width && canvas.height() == height
                      ? ", but not the right colors in them"
                      : "")
              << ".\nHint: " << hint);
    CHECK(as_expected);
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
        "Hint: in this order: remember width and height, make the pixels with new "
        "Pixel[size()], and give each the color. size() is width_ times height_; ( ) in place of "
        "[ ] makes one pixel; `int width_ = width;` would make another variable");
    CHECK(canvas.width() == 3);
    CHECK(canvas.height() == 2);
    REQUIRE((canvas.begin() != nullptr));
    {
        INFO("pixels that were used and never made: " << Watch::dead_uses);
        REQUIRE(Watch::dead_uses == 0);
    }
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
        check_numbered("the copy", copy, 3, 2,
                       "take over both sides from `other` first, since size() is made of them; "
                       "then new pixels, then std::copy from the other's to your own");
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
        check_numbered("the canvas that was moved to", taken, 3, 2, "take over all three members");
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
        const char* const hint = "std::swap each of the three members with other's";
        check_numbered("a, after a = b,", a, 3, 2, hint);
        check_numbered("b, after a = b,", b, 3, 2, hint);
        CHECK((a.begin() != b.begin()));
        a.at(0, 0) = WatchedPixel{99};
        const int made = Watch::made;
        const WatchedPixel* const pixels = b.begin();
        a = std::move(b);
        INFO("a = std::move(b) made " << Watch::made - made << " pixels, and should make none");
        CHECK(Watch::made == made);
        CHECK((a.begin() == pixels));
        check_numbered("a, after a = std::move(b),", a, 3, 2, hint);
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
                INFO("pixel (" << x << ", " << y
                               << ")\nHint: swap rows, not columns: row y with row height - 1 - y, "
                                  "for each y below height / 2: less leaves a row out, more swaps "
                                  "rows back");
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
        const WatchedPixel* const found = &rt::largest(canvas);
        bool is_in_canvas = false;
        for (const WatchedPixel& pixel : canvas) is_in_canvas |= &pixel == found;
        {
            INFO(
                "the reference leads to no pixel of the canvas.\nHint: is `pixel` of your loop a "
                "copy (no &), do you return a variable of the function, or is its parameter a "
                "value (no &)? All of these are gone when the function ends");
            REQUIRE(is_in_canvas);
        }
        INFO(
            "Hint: `found = &pixel` where `*found < pixel`, in this order, and pixels, not "
            "addresses");
        CHECK(found->value() == 55);
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
        check_numbered("the canvas, after canvas = canvas,", canvas, 3, 2,
                       "std::swap each of the three members with other's");
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
    try {
        const Canvas one{1, 1, WatchedPixel{1}};
    } catch (const std::invalid_argument&) {
        FAIL("1 x 1 was refused.\nHint: it is allowed; refuse width < 1, and not width <= 1");
    }
    for (const auto& [width, height] : {std::pair{0, 5}, std::pair{5, 0}, std::pair{-1, 5},
                                        std::pair{5, -1}, std::pair{-2, -3}}) {
        bool refused = false;
        const char* came = "were not refused";
        try {
            const Canvas canvas{width, height, WatchedPixel{1}};
        } catch (const std::invalid_argument&) {
            refused = true;
        } catch (const std::bad_alloc&) {
            came = "came as far as new, which was asked for an absurd number of pixels";
        } catch (...) {
            came = "were refused, but not by std::invalid_argument";
        }
        INFO("sides of " << width << " x " << height << ' ' << came
                         << ".\nHint: throw std::invalid_argument, before anything else, when "
                            "width < 1 or (||) height < 1");
        CHECK(refused);
    }
    INFO(
        "Hint: throw before new. An object whose constructor throws is never destroyed, and what "
        "it held is lost");
    check_memory();
}

TEST_CASE("00.2 odd heights and long rows are flipped", "[00.2][hard]") {
    const Watch watch;
    for (const auto& [width, height] :
         {std::pair{1, 1}, std::pair{1, 5}, std::pair{9, 3}, std::pair{2, 4}, std::pair{7, 1}}) {
        const Canvas canvas = numbered(width, height);
        CHECK(is_numbered(rt::flipped(rt::flipped(canvas)), width, height));
        const Canvas turned = rt::flipped(canvas);
        INFO(width << " x " << height
                   << "\nHint: rows change places, not columns; the middle one of an odd number "
                      "of rows stays");
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                CHECK(turned.at(x, y).value() == canvas.at(x, height - 1 - y).value());
    }
}
