#include <rt/canvas.hpp>
#include <rt/todo.hpp>
#include <string>
#include <type_traits>

#include "checkpoint.hpp"
#include "watch.hpp"

using namespace checkpoint;
using Canvas = rt::Canvas<WatchedPixel>;

namespace {

// Widths and heights: square or not, odd or even, one pixel, more rows than columns
// and the reverse.
constexpr std::pair<int, int> sizes[] = {{3, 2}, {1, 1}, {4, 4}, {1, 5}, {9, 3}, {2, 13}, {40, 30}};

// Pixel (x, y) is 100 y + x.
constexpr int number_at(int x, int y) {
    return 100 * y + x;
}
Canvas numbered(int width, int height) {
    Canvas canvas{width, height, WatchedPixel{0}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) canvas.at(x, y) = WatchedPixel{number_at(x, y)};
    return canvas;
}

// The first thing that is wrong with a canvas whose pixel (x, y) should be expected(x, y); empty if
// nothing is wrong.
template <class Expected>
std::string complaint(const Canvas& canvas, int width, int height, Expected expected) {
    if (canvas.width() != width || canvas.height() != height)
        return "expected " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels, actual " + std::to_string(canvas.width()) + " x " +
               std::to_string(canvas.height());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (const int value = canvas.at(x, y).value(); value != expected(x, y))
                return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + "): expected " +
                       std::to_string(expected(x, y)) + ", actual " + std::to_string(value);
    return {};
}

// Says what is wrong with a canvas that should be numbered.
void check_numbered(const char* what, const Canvas& canvas, int width, int height,
                    const char* hint) {
    const std::string wrong = complaint(canvas, width, height, number_at);
    INFO(what << " is wrong.\nHint: " << hint);
    CHECK(wrong == "");
}

// Checks whether a canvas has these very pixels, which belong or belonged to another canvas.
void check_pixels(const Canvas& canvas, const WatchedPixel* pixels, const std::string& expected) {
    const std::string actual = canvas.begin() == pixels ? "the same pixels" : "other pixels";
    CHECK(actual == expected);
}

void check_equal(int actual, int expected) {
    CHECK(actual == expected);
}

// At the end of a test case, when all canvases are gone.
void check_memory() {
    {
        INFO("pixels that were never destroyed: "
             << Watch::live_objects() << ", in " << Watch::live_blocks()
             << " blocks of memory that were never released.\nHint: delete[] pixels_ in the "
                "destructor, and never overwrite a pointer that still owns pixels");
        CHECK(Watch::live_objects() == 0);
        CHECK(Watch::live_blocks() == 0);
    }
    {
        INFO("released twice: "
             << Watch::released_twice
             << ".\nHint: two canvases had the same pixels_, and each of them released the pixels");
        CHECK(Watch::released_twice == 0);
    }
    {
        INFO(
            "pixels were copied byte by byte, which is correct only for some types.\nHint: use "
            "std::copy, std::fill or = instead of memcpy");
        CHECK(Watch::byte_copies == 0);
    }
    INFO("uses of destroyed pixels: " << Watch::dead_uses
                                      << ".\nHint: a pointer or a reference still referred to the "
                                         "pixels after they had been destroyed");
    CHECK(Watch::dead_uses == 0);
}

}  // namespace

TEST_CASE("00.3 a new canvas has the given size and color", "[00.3]") {
    const Watch watch;
    for (const auto& [width, height] : sizes) {
        const int before = Watch::live_objects();
        const Canvas canvas{width, height, WatchedPixel{7}};
        INFO(
            "Hint: in this order: store width and height, make the pixels with new Pixel[size()], "
            "and give each the color. size() is width_ times height_; ( ) instead of [ ] makes a "
            "single pixel; `int width_ = width;` would make another variable");
        check_equal(canvas.width(), width);
        check_equal(canvas.height(), height);
        REQUIRE((canvas.begin() != nullptr));
        {
            INFO("pixels that were used but never constructed: " << Watch::dead_uses);
            REQUIRE(Watch::dead_uses == 0);
        }
        {
            INFO("the number of pixels made for " << width << " x " << height);
            check_equal(Watch::live_objects() - before, width * height);
        }
        CHECK(complaint(canvas, width, height, [](int, int) { return 7; }) == "");
    }
    INFO("a canvas without a color gets the pixel's default value");
    CHECK(complaint(Canvas{2, 2}, 2, 2, [](int, int) { return 0; }) == "");
}

TEST_CASE("00.3 a canvas releases its pixels when it is destroyed", "[00.3]") {
    const Watch watch;
    for (const auto& [width, height] : sizes) {
        { const Canvas canvas{width, height, WatchedPixel{7}}; }
        check_memory();
    }
}

TEST_CASE("00.3 a copy has its own pixels", "[00.3]") {
    const Watch watch;
    for (const auto& [width, height] : sizes) {
        const Canvas original = numbered(width, height);
        const int before = Watch::live_objects();
        Canvas copy = original;
        check_numbered("the copy", copy, width, height,
                       "copy width and height from `other` first, since size() needs them; then "
                       "make new pixels, then std::copy the other's pixels to your own");
        {
            INFO(
                "both canvases share one block of pixels in memory.\nHint: copying the pointer "
                "does not copy the picture: make new pixels, then copy the colors");
            check_pixels(copy, original.begin(), "other pixels");
        }
        {
            INFO("the number of pixels that the copy made");
            check_equal(Watch::live_objects() - before, width * height);
        }
        copy.at(width - 1, height - 1) = WatchedPixel{-9};
        check_numbered("the original, after the copy was painted on,", original, width, height,
                       "a copy needs pixels of its own");
    }
    check_memory();
}

TEST_CASE("00.3 a move takes over the pixels of the other canvas", "[00.3]") {
    const Watch watch;
    for (const auto& [width, height] : sizes) {
        Canvas original = numbered(width, height);
        const WatchedPixel* const pixels = original.begin();
        const int made = Watch::made;
        const Canvas taken = std::move(original);
        {
            INFO(
                "pixels made or copied by the move.\nHint: take over the pointer, and set the "
                "other canvas's pointer to nullptr");
            check_equal(Watch::made - made, 0);
            check_pixels(taken, pixels, "the same pixels");
        }
        check_numbered("the canvas that was moved to", taken, width, height,
                       "take over all three members");
        INFO("a canvas that was moved from must be empty");
        check_equal(original.width(), 0);
        check_equal(original.height(), 0);
        check_pixels(original, nullptr, "the same pixels");
    }
    check_memory();
}

TEST_CASE("00.3 assignment copies or moves and releases the old pixels", "[00.3]") {
    const Watch watch;
    const char* const hint =
        "call std::swap for each of the three members and the same member of other";
    for (const auto& [width, height] : sizes)
        for (const bool same_size : {false, true}) {
            Canvas a{same_size ? width : 4, same_size ? height : 2, WatchedPixel{1}};
            Canvas b = numbered(width, height);
            const Canvas* const itself = &(a = b);
            Canvas c{1, 1};
            const Canvas* const another_one = &(c = a);
            {
                INFO("the result of the expression a = b\nHint: return *this;");
                const std::string actual =
                    itself == &a && another_one == &c ? "a itself" : "another canvas";
                CHECK(actual == "a itself");
            }
            check_numbered("a, after a = b,", a, width, height, hint);
            check_numbered("b, after a = b,", b, width, height, hint);
            check_pixels(a, b.begin(), "other pixels");
            a = Canvas{same_size ? width : 5, same_size ? height : 1, WatchedPixel{1}};
            const int made = Watch::made;
            const WatchedPixel* const pixels = b.begin();
            a = std::move(b);
            {
                INFO("pixels made by a = std::move(b)");
                check_equal(Watch::made - made, 0);
                check_pixels(a, pixels, "the same pixels");
            }
            check_numbered("a, after a = std::move(b),", a, width, height, hint);
        }
    check_memory();
}

TEST_CASE("00.3 flipped swaps top and bottom", "[00.3]") {
    const Watch watch;
    for (const auto& [width, height] : sizes) {
        const Canvas canvas = numbered(width, height);
        const Canvas turned = rt::flipped(canvas);
        {
            INFO(width
                 << " x " << height
                 << ", flipped.\nHint: swap rows, not columns: swap row y with row height - 1 - y, "
                    "for each y below height / 2. With fewer swaps, a row is left out; with more, "
                    "rows are swapped back. If the number of rows is odd, the middle row stays");
            const int last = height - 1;
            REQUIRE(complaint(turned, width, height,
                              [=](int x, int y) { return number_at(x, last - y); }) == "");
        }
        check_numbered("the canvas whose copy was passed to flipped", canvas, width, height,
                       "flip the parameter itself, which is passed by value");
    }
    check_memory();
}

TEST_CASE("00.3 flipped returns the pixels of a canvas that is moved into it", "[00.3]") {
    const Watch watch;
    for (const auto& [width, height] : sizes) {
        Canvas canvas = numbered(width, height);
        const WatchedPixel* const pixels = canvas.begin();
        const int before = Watch::live_objects();
        Watch::most_live = before;
        const Canvas turned = rt::flipped(std::move(canvas));
        const int more = Watch::most_live - before;
        {
            INFO(
                "the returned canvas has different memory.\nHint: take the canvas by value, "
                "flip it, and return it by its name");
            check_pixels(turned, pixels, "the same pixels");
        }
        INFO(width << " x " << height << " pixels, and at one moment there were " << more
                   << " more. A swap of two pixels needs one or two more.\nHint: use no second "
                      "canvas and no extra row: std::swap(a, b) swaps two pixels");
        CHECK(more <= 2);
    }
    check_memory();
}

TEST_CASE("00.3 largest returns a reference to the pixel itself", "[00.3]") {
    const Watch watch;
    for (const auto& [width, height] : {std::pair{3, 2}, {1, 1}, {1, 6}, {4, 5}}) {
        Canvas canvas{width, height, WatchedPixel{}};
        for (int place = 0; place < width * height; ++place) {
            // The numbers go up and down, and each pixel in turn is the largest.
            for (int i = 0; i < width * height; ++i)
                canvas.begin()[i] = WatchedPixel{i == place ? 55 : 7 * i % 5};
            const WatchedPixel* const found = &rt::largest(canvas);
            const bool is_in_canvas = canvas.begin() <= found && found < canvas.end();
            {
                INFO(
                    "the reference does not refer to a pixel of the canvas.\nHint: check that "
                    "`pixel` in your loop is not a copy, that you do not return a variable of the "
                    "function, and that the parameter is not passed by value: copies and variables "
                    "of the function no longer exist when it returns. An & may be missing");
                REQUIRE(is_in_canvas);
            }
            INFO(
                width << " x " << height << " pixels, the largest is (" << place % width << ", "
                      << place / width
                      << ").\nHint: go through all pixels, including the first and the last; "
                         "`found = &pixel` if `*found < pixel`, in this order; compare pixels, not "
                         "addresses");
            REQUIRE(found->value() == 55);
        }
    }
    check_memory();
}

TEST_CASE("00.3 largest returns the first of several equally large pixels", "[00.3][hard]") {
    const Watch watch;
    Canvas canvas{5, 4, WatchedPixel{-5}};
    // Catch2 would print addresses, which tell a person nothing.
    const auto check_found = [&](int x, int y, const char* hint) {
        const auto found = &rt::largest(canvas) - canvas.begin();
        INFO("Hint: " << hint);
        const std::string actual = "pixel " + std::to_string(found % 5) + ", " +
                                   std::to_string(found / 5),
                          expected = "pixel " + std::to_string(x) + ", " + std::to_string(y);
        REQUIRE(actual == expected);
    };
    check_found(
        0, 0,
        "all pixels are equal: the first one stays unless another is larger, so compare with < and "
        "not <=. Start with the first pixel itself, not with 0, because all pixels are below 0");
    canvas.at(2, 1) = canvas.at(0, 2) = canvas.at(1, 3) = WatchedPixel{-4};
    check_found(2, 1,
                "the first of the largest pixels counts, row by row from the top: replace it only "
                "by a pixel that is larger");
    canvas.at(4, 3) = WatchedPixel{-3};
    check_found(4, 3, "the largest pixel may be the last one");
}

TEST_CASE("00.3 a canvas may be assigned to itself", "[00.3][hard]") {
    const Watch watch;
    {
        Canvas canvas = numbered(3, 2);
        const Canvas& same = canvas;
        canvas = same;
        INFO("Hint: make the new pixels first, and release the old ones last");
        CHECK(Watch::dead_uses == 0);
        check_numbered("the canvas, after canvas = canvas,", canvas, 3, 2,
                       "call std::swap for each of the three members and the same member of other");
    }
    check_memory();
}

TEST_CASE("00.3 a vector of canvases grows without copies", "[00.3][hard]") {
    const Watch watch;
    {
        answer::CanvasVector canvases;
        for (int i = 0; i < 9; ++i) {
            Canvas canvas = numbered(2, 2);
            const int made = Watch::made;
            canvases.push_back(std::move(canvas));
            INFO("the number of pixels made when canvas number "
                 << i
                 << " was moved into the vector.\nHint: a vector that grows moves its elements "
                    "only if their move constructor is noexcept: Canvas(Canvas&& other) noexcept");
            check_equal(Watch::made - made, 0);
        }
        for (std::size_t i = 0; i < 9; ++i)
            check_numbered("a canvas of the vector", canvases[i], 2, 2,
                           "take over all three members");
    }
    check_memory();
}

TEST_CASE("00.3 a canvas that was moved from can be used again", "[00.3][hard]") {
    const Watch watch;
    {
        Canvas canvas = numbered(3, 2);
        Canvas taken = std::move(canvas);
        Canvas empty_copy = canvas;
        INFO(
            "Hint: leave a canvas of width 0 and height 0 without pixels, which can be copied, "
            "assigned and flipped");
        check_equal(static_cast<int>(empty_copy.size()), 0);
        check_equal(static_cast<int>(rt::flipped(empty_copy).size()), 0);
        canvas = taken;
        check_numbered("an empty canvas to which another was assigned", canvas, 3, 2,
                       "call std::swap for each of the three members and the same member of other");
        taken = empty_copy;
        check_equal(taken.width(), 0);
        check_equal(taken.height(), 0);
        taken = std::move(canvas);
        check_numbered("an empty canvas into which another was moved", taken, 3, 2,
                       "call std::swap for each of the three members and the same member of other");
        Canvas emptied = numbered(1, 2);
        const Canvas owner = std::move(emptied);
        taken = std::move(emptied);
        check_equal(static_cast<int>(taken.size()), 0);
    }
    check_memory();
}

TEST_CASE("00.3 a width or height below 1 is refused and no memory is lost", "[00.3][hard]") {
    const Watch watch;
    try {
        const Canvas one{1, 1, WatchedPixel{1}};
    } catch (const std::invalid_argument&) {
        FAIL(
            "a canvas of 1 x 1 was refused.\nHint: this size is allowed: refuse width < 1, not "
            "width <= 1");
    }
    for (const auto& [width, height] : {std::pair{0, 5}, std::pair{5, 0}, std::pair{-1, 5},
                                        std::pair{5, -1}, std::pair{-2, -3}, std::pair{0, 0}}) {
        std::string actual = "not refused";
        try {
            const Canvas canvas{width, height, WatchedPixel{1}};
        } catch (const std::invalid_argument&) {
            continue;
        } catch (const std::bad_alloc&) {
            actual = "not refused before new was called with an absurd number of pixels";
        } catch (const rt::NotImplemented&) {
            throw;
        } catch (...) {
            actual = "refused by another exception";
        }
        INFO("a canvas of " << width << " x " << height
                            << ".\nHint: throw std::invalid_argument, before anything else, when "
                               "width < 1 or (||) height < 1");
        CHECK(actual == "refused by std::invalid_argument");
    }
    INFO(
        "Hint: throw before new. An object whose constructor throws is never destroyed, and the "
        "memory that it held leaks");
    check_memory();
}

TEST_CASE("00.3 the old canvas is kept if there is no memory for a new one", "[00.3][hard]") {
    const Watch watch;
    {
        Canvas canvas = numbered(3, 2);
        const Canvas other{2, 5, WatchedPixel{1}};
        Watch::is_full = true;
        std::string actual = "a canvas";
        try {
            const Canvas large{1 << 20, 1 << 20, WatchedPixel{1}};
        } catch (const std::bad_alloc&) {
            actual = "std::bad_alloc";
        } catch (const std::exception& error) {
            actual = error.what();
        }
        {
            INFO(
                "a million million pixels, for which there is no memory: new throws.\nHint: any "
                "size from 1 x 1 up is allowed; do not catch what new throws");
            CHECK(actual == "std::bad_alloc");
        }
        {
            INFO("bytes requested from new: "
                 << Watch::asked
                 << ".\nHint: width times height may not fit into an int; use size()");
            if (Watch::asked != 0) CHECK(Watch::asked >= std::size_t{1} << 40);
        }
        bool thrown = false;
        try {
            canvas = other;
        } catch (const std::bad_alloc&) {
            thrown = true;
        }
        if (thrown)
            check_numbered("a, after a = b for which there was no memory,", canvas, 3, 2,
                           "copy first, then swap: the parameter `other` of operator= is a value");
        Watch::is_full = false;
    }
    check_memory();
}
