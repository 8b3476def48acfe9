#include <app/errors.hpp>
#include <open_meshed.hpp>
#include <rt/image_file.hpp>
#include <rt/light_file.hpp>
#include <scene_file.hpp>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

using namespace checkpoint;
using rt::Color;

namespace {

std::string scene_with(const std::string& sky) {
    return R"({"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]}, "materials": {}, "sky": )" +
           sky + "}";
}

rt::MeshedDescription read(const TemporaryFolder& folder, const std::string& sky) {
    write_file(folder / "one.json", scene_with(sky));
    return full_renderer::read_scene(folder / "one.json");
}

// What is said of a sky, after the name of the file.
std::string refusal(const TemporaryFolder& folder, const std::string& sky) {
    try {
        read(folder, sky);
    } catch (const app::UsageError& error) {
        const std::string words = error.what();
        return words.substr(words.find("one.json: ") + 10);
    }
    return {};
}

}  // namespace

TEST_CASE("a sky may be a picture, turned and multiplied") {
    const TemporaryFolder folder;
    const rt::Image picture{4, 2, {100, 1, 0}};
    write_file(folder / "sky.pfm", rt::encode_pfm(picture));
    write_file(folder / "sky.hdr", rt::encode_hdr(picture));
    for (const char* const name : {"sky.pfm", "sky.hdr"}) {
        const auto scene = read(folder, R"({"image": ")" + std::string{name} + R"("})");
        REQUIRE(scene.sky_image);
        CHECK(scene.sky_image->turn == 0);
        CHECK(scene.sky_image->scale == 1);
        const auto image = static_cast<std::size_t>(scene.sky_image->image);
        CHECK(scene.images.at(image).at(3, 1).r == 100);
    }
    const auto turned =
        read(folder, R"({"image": "sky.pfm", "rotate_deg": -90, "scale": 2.5})").sky_image;
    REQUIRE(turned);
    CHECK(turned->turn == Real(0.75));
    CHECK(turned->scale == Real(2.5));
    for (const char* const degrees : {"360", "-360", "0", "-1e-30"}) {
        const auto whole =
            read(folder, R"({"image": "sky.pfm", "rotate_deg": )" + std::string{degrees} + "}");
        CHECK(whole.sky_image->turn == 0);
    }
}

TEST_CASE("a picture of the sky that cannot be used is refused with the reason") {
    const TemporaryFolder folder;
    const auto with = [&](const std::string& bytes) {
        write_file(folder / "sky.pfm", bytes);
        return refusal(folder, R"({"image": "sky.pfm"})");
    };
    const std::string pixel = "PF\n1 1\n-1.0\n";
    const std::string start = "sky.image is \"sky.pfm\", which cannot be used: the file ";
    CHECK(with(pixel + std::string(12, '\0')).empty());
    CHECK(with(pixel) == start + "ends too early");
    CHECK(with(pixel + std::string("\0\0\0\0\0\0\xc0\x7f\0\0\0\0", 12)) ==
          start + "has a NaN for a pixel");
    CHECK(with(rt::encode_pfm(rt::Image{1, 1, {-1, 0, 0}})) ==
          start + "has a pixel with less light than 0");
    CHECK(with(rt::encode_png(rt::Image{1, 1})) == start + "is neither a .hdr nor a .pfm file");
    CHECK(with("PF\n4096 4096\n-1.0\n") ==
          "sky.image is \"sky.pfm\", which is too large; all images of a scene may have 8388608 "
          "pixels together");
    CHECK(refusal(folder, R"({"image": "../sky.pfm"})").find("leads out of the scene's folder") !=
          std::string::npos);
    CHECK(refusal(folder, R"({"image": "none.hdr"})").find("does not exist") != std::string::npos);
    CHECK(refusal(folder, R"({"image": 7})").find("sky.image") == 0);
    for (const char* const wrong :
         {R"({"image": "sky.pfm", "rotate_deg": 361})", R"({"image": "sky.pfm", "scale": -1})",
          R"({"image": "sky.pfm", "below": "#000000"})", R"({"below": "#000000"})"})
        CHECK_FALSE(refusal(folder, wrong).empty());
}

TEST_CASE("chapter 08's program says what draws a picture of the sky") {
    const auto read_none = [](const app::Value&, const std::string&, const std::string&,
                              std::size_t) { return std::string{}; };
    try {
        effects::parse_scene(scene_with(R"({"image": "sky.hdr"})"), "one.json",
                             effects::ReadNeighbor{read_none});
        FAIL("was not refused");
    } catch (const app::UsageError& error) {
        CHECK(std::string{error.what()} ==
              "one.json: sky.image is not drawn by this program; ./course run 08 takes the one "
              "that draws it");
    }
}
