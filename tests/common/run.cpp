#include <app/json.hpp>
#include <app/run.hpp>
#include <cmath>
#include <csignal>
#include <rt/light_file.hpp>
#include <study/report.hpp>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

using checkpoint::read_file;
using checkpoint::TemporaryFolder;

namespace {

app::Settings seen;  // what the last run asked for

app::Picture render(const app::Settings& settings, app::Progress& progress) {
    seen = settings;
    return {app::draw(settings, progress, [](int x, int) {
        return rt::Color{rt::Real(x % 2), 0, 0};
    })};
}

void run_study(study::Report& report) {
    report.add({"s", "v", 1, "n", 2, "e", 3, "c"});
}

app::Program program() {
    return {.name = "99_test",
            .about = "A test",
            .defaults = {.width = 8, .height = 4, .spp = 3, .depth = 5, .threads = 2, .seed = 7},
            .render = render,
            .study = run_study};
}

int run(const std::vector<std::string>& options, const app::Program& program = ::program()) {
    std::vector<const char*> arguments{"99_test", "--quiet"};
    for (const std::string& option : options) arguments.push_back(option.c_str());
    return app::run(static_cast<int>(arguments.size()), arguments.data(), program);
}

}  // namespace

TEST_CASE("a program draws with its defaults", "[run]") {
    const TemporaryFolder folder;
    CHECK(run({"--out", folder.file("a.ppm")}) == app::done);
    CHECK(seen.width == 8);
    CHECK(seen.height == 4);
    CHECK(seen.spp == 3);
    CHECK(seen.depth == 5);
    CHECK(seen.threads == 2);
    CHECK(seen.seed == 7u);
    CHECK(read_file(folder / "a.ppm").find("P6\n8 4\n255\n") == 0);
}

TEST_CASE("options replace the defaults", "[run]") {
    const TemporaryFolder folder;
    CHECK(run({"--out", folder.file("a.png"), "--width", "1", "--height", "10000", "--spp", "9",
               "--depth", "1", "--threads", "1", "--seed", "18446744073709551615"}) == app::done);
    CHECK(seen.width == 1);
    CHECK(seen.height == 10000);
    CHECK(seen.spp == 9);
    CHECK(seen.depth == 1);
    CHECK(seen.threads == 1);
    CHECK(seen.seed == 18446744073709551615u);
    CHECK(read_file(folder / "a.png").find("PNG") == 1);
}

TEST_CASE("a program has no options that do not apply", "[run]") {
    const TemporaryFolder folder;
    app::Program plain = program();
    plain.defaults = {.width = 8, .height = 4};
    plain.study = nullptr;
    CHECK(run({"--out", folder.file("a.png")}, plain) == app::done);
    CHECK_FALSE(seen.seed.has_value());
    for (const char* const option : {"--spp", "--depth", "--threads", "--seed", "--study"})
        CHECK(run({"--out", folder.file("b.png"), option, "1"}, plain) == app::bad_input);
    CHECK(folder.count() == 1);
}

TEST_CASE("a camera is moved by options and stays where it was without them", "[run]") {
    const TemporaryFolder folder;
    app::Program camera = program();
    const rt::View usual{{1, 2, 3}, {4, 5, 6}, {0, 1, 0}, rt::radians(33)};
    camera.defaults.view = usual;
    const auto view_after = [&](std::vector<std::string> options) {
        options.insert(options.end(), {"--out", folder.file("a.png")});
        REQUIRE(run(options, camera) == app::done);
        return *seen.view;
    };
    CHECK(view_after({}).from == usual.from);
    CHECK(view_after({}).at == usual.at);
    CHECK(view_after({}).vertical_fov == usual.vertical_fov);
    CHECK(view_after({"--from", "-1,0.5,2e3"}).from == rt::Vec3{-1, rt::Real(0.5), 2000});
    CHECK(view_after({"--from", "-1,0.5,2e3"}).at == usual.at);
    CHECK(view_after({"--at=-7,8,-9"}).at == rt::Vec3{-7, 8, -9});
    CHECK(view_after({"--fov", "60"}).vertical_fov == rt::radians(60));
    CHECK(view_after({"--fov", "60"}).from == usual.from);
    for (const char* const option : {"--from", "--at", "--fov"})
        for (const char* const value : {"", "1,2", "a", "1,2,3,4", "nan,1,2", "0"})
            CHECK(run({"--out", folder.file("b.png"), option, value}, camera) == app::bad_input);
    CHECK(run({"--out", folder.file("b.png"), "--from", "4,5,6"}, camera) == app::bad_input);
    // A program whose camera cannot be moved has no such option.
    CHECK(run({"--out", folder.file("b.png"), "--fov", "60"}) == app::bad_input);
}

TEST_CASE("a program describes its options and their defaults", "[run]") {
    app::Program with_more = program();
    with_more.choices = {{"ending", "How a path ends", {"sky", "black"}}};
    const auto described = [](const app::Program& one) {
        return app::texts_in(app::describe(one), "--describe");
    };
    auto defaults = described(with_more);
    CHECK(defaults["out"] == "99_test.png");
    CHECK(defaults["width"] == "8");
    CHECK(defaults["spp"] == "3");
    CHECK(defaults["seed"] == "7");
    CHECK(defaults["ending"] == "sky");
    CHECK(defaults.count("study") == 1);
    CHECK(defaults.count("show") == 0);
    with_more.shows = {"normal", "distance"};
    CHECK(described(with_more)["show"] == "normal distance");
    app::Program plain = program();
    plain.defaults = {.width = 8, .height = 4};
    plain.study = nullptr;
    defaults = described(plain);
    for (const char* const option : {"spp", "depth", "threads", "seed", "study", "ending"})
        CHECK(defaults.count(option) == 0);
    CHECK(run({"--describe"}) == app::done);
}

TEST_CASE("a chapter may encode PPM files in its own way", "[run]") {
    const TemporaryFolder folder;
    app::Program own = program();
    own.encode_ppm = [](const rt::Image&) { return std::string("mine"); };
    CHECK(run({"--out", folder.file("a.ppm")}, own) == app::done);
    CHECK(run({"--out", folder.file("a.png")}, own) == app::done);
    CHECK(read_file(folder / "a.ppm") == "mine");
    CHECK(read_file(folder / "a.png").find("PNG") == 1);
}

TEST_CASE("a file's extension says whether it holds light or what a screen shows", "[run]") {
    const TemporaryFolder folder;
    app::Program bright = program();
    bright.render = [](const app::Settings&, app::Progress&) {
        return app::Picture{rt::Image{2, 1, {8, 1, rt::Real(0.25)}}};
    };
    for (const char* const name : {"a.pfm", "a.hdr"}) {
        CHECK(run({"--out", folder.file(name)}, bright) == app::done);
        CHECK(rt::decode_light(read_file(folder / name), 2) ==
              rt::Image{2, 1, {8, 1, rt::Real(0.25)}});
    }
    for (const char* const name : {"a.PFM", "a.exr", "a.hdr.gz"})
        CHECK(run({"--out", folder.file(name)}, bright) == app::bad_input);
}

TEST_CASE("each stop of exposure doubles the light of the file", "[run]") {
    const TemporaryFolder folder;
    app::Program bright = program();
    bright.defaults.exposure = 0;
    bright.shows = {"normal"};
    bright.render = [](const app::Settings&, app::Progress&) {
        return app::Picture{rt::Image{2, 1, {8, 1, rt::Real(0.25)}}};
    };
    const auto red = [&](const std::string& stops) {
        REQUIRE(run({"--out", folder.file("a.pfm"), "--exposure", stops}, bright) == app::done);
        return rt::decode_light(read_file(folder / "a.pfm"), 2).at(1, 0).r;
    };
    CHECK(red("0") == 8);
    CHECK(red("2") == 32);
    CHECK(red("-3") == 1);
    CHECK(red("0.5") == static_cast<rt::Real>(static_cast<float>(8 * std::sqrt(2.0))));
    CHECK(run({"--out", folder.file("b.png"), "--exposure=-32"}, bright) == app::done);
    for (const char* const stops : {"", "a", "nan", "inf", "33", "-32.1", "1,2", "0x1"})
        CHECK(run({"--out", folder.file("c.png"), "--exposure", stops}, bright) == app::bad_input);
    CHECK(run({"--out", folder.file("c.png"), "--show", "normal"}, bright) == app::done);
    CHECK(run({"--out", folder.file("c.png"), "--show", "normal", "--exposure", "1"}, bright) ==
          app::bad_input);
    // A picture with a figure around it has no such option.
    CHECK(run({"--out", folder.file("c.png"), "--exposure", "1"}) == app::bad_input);
}

TEST_CASE("a study makes its folder and draws no picture", "[run]") {
    const TemporaryFolder folder;
    CHECK(run({"--study", folder.file("deep/er")}) == app::done);
    CHECK(read_file(folder / "deep/er/99_test.csv").find("\ns,v," + study::precision()) !=
          std::string::npos);
    CHECK(folder.count() == 1);
}

TEST_CASE("a picture that was stopped is written, and the exit code says so", "[run]") {
    const TemporaryFolder folder;
    app::Program stopped = program();
    stopped.render = [](const app::Settings&, app::Progress&) {
        const app::Interruption interruption;
        app::Picture picture{rt::Image{9, 9}};
        app::draw_unfinished(picture.image);
        CHECK(app::Interruption::signal() == 0);
        std::raise(SIGINT);
        picture.stopped = {app::Interruption::signal(), 0.5};
        return picture;
    };
    const auto before = std::signal(SIGINT, SIG_DFL);  // the test program has a handler of its own
    CHECK(run({"--out", folder.file("a.ppm")}, stopped) == 128 + SIGINT);
    CHECK(read_file(folder / "a.ppm").find("P6\n9 9\n255\n") == 0);
    // If nothing was drawn, an older picture stays.
    stopped.render = [](const app::Settings&, app::Progress&) {
        app::Picture picture{rt::Image{3, 3}};
        picture.stopped = {SIGINT, 0.001};
        return picture;
    };
    CHECK(run({"--out", folder.file("a.ppm")}, stopped) == 128 + SIGINT);
    CHECK(read_file(folder / "a.ppm").find("P6\n9 9\n255\n") == 0);
    CHECK(run({"--out", folder.file("new.ppm")}, stopped) == 128 + SIGINT);
    CHECK(read_file(folder / "new.ppm").find("P6\n3 3\n255\n") == 0);
    // While there is no Interruption, signals do what they did.
    CHECK(std::signal(SIGINT, before) == SIG_DFL);
}

TEST_CASE("an ignored signal is still ignored after another one came", "[run]") {
    const auto interrupt = std::signal(SIGINT, SIG_IGN), terminate = std::signal(SIGTERM, SIG_DFL);
    {
        const app::Interruption interruption;
        std::raise(SIGINT);
        CHECK(app::Interruption::signal() == 0);
        std::raise(SIGTERM);
        CHECK(app::Interruption::signal() == SIGTERM);
        CHECK(std::signal(SIGINT, SIG_IGN) == SIG_IGN);
    }
    std::signal(SIGTERM, terminate);
    std::signal(SIGINT, interrupt);
}

TEST_CASE("a program that reads no file takes none", "[run]") {
    const TemporaryFolder folder;
    CHECK(run({"--out", folder.file("a.png"), "scene.json"}) == app::bad_input);
    app::Program reads = program();
    reads.reads = "A file";
    CHECK(run({"--out", folder.file("a.png"), "scene.json"}, reads) == app::done);
    CHECK(seen.file == "scene.json");
    CHECK(run({"--out", folder.file("a.png"), ""}, reads) == app::bad_input);
}

TEST_CASE("a program explains itself only where it can and is asked to", "[run]") {
    const TemporaryFolder folder;
    CHECK(run({"--out", folder.file("a.png"), "--explain"}) == app::bad_input);
    app::Program explains = program();
    explains.explains = true;
    CHECK(run({"--out", folder.file("a.png")}, explains) == app::done);
    CHECK_FALSE(seen.explain);
    // run() is quiet, and so is the explanation.
    CHECK(run({"--out", folder.file("a.png"), "--explain"}, explains) == app::done);
    CHECK_FALSE(seen.explain);
    const std::string file = folder.file("a.png");
    const char* const aloud[] = {"99_test", "--explain", "--out", file.c_str()};
    CHECK(app::run(4, aloud, explains) == app::done);
    CHECK(seen.explain);
}
