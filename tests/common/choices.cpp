#include <app/run.hpp>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace {

std::string picked_color;
std::string shown;
bool is_framed = false;

app::Picture note_choice(const app::Settings& settings, app::Progress&) {
    picked_color = settings.picked.at(0);
    shown = settings.show;
    is_framed = settings.given.count("framed") > 0;
    return {rt::Image{1, 1}};
}

// The exit code of a program that has a choice of colors.
int run_with(std::vector<const char*> arguments) {
    picked_color = "";
    shown = "";
    const checkpoint::TemporaryFolder folder;
    const std::string out = folder.file("a.ppm");
    arguments.insert(arguments.begin(), {"test", "--quiet", "--out", out.c_str()});
    return app::run(static_cast<int>(arguments.size()), arguments.data(),
                    {.name = "test",
                     .about = "",
                     .defaults = {},
                     .render = note_choice,
                     .study = nullptr,
                     .choices = {{"color", "What it is painted with", {"red", "blue"}}},
                     .flags = {{"framed", "With a frame around it"}},
                     .shows = {"distance", "sphere"}});
}

}  // namespace

TEST_CASE("a program has choices of its own and their first word is the default", "[choices]") {
    CHECK(run_with({}) == app::done);
    CHECK(picked_color == "red");
    CHECK(run_with({"--color", "blue"}) == app::done);
    CHECK(picked_color == "blue");
}

TEST_CASE("a choice takes only its own words", "[choices]") {
    CHECK(run_with({"--color", "green"}) == app::bad_input);
    CHECK(run_with({"--color"}) == app::bad_input);
    CHECK(run_with({"--color", ""}) == app::bad_input);
    CHECK(run_with({"--shade", "red"}) == app::bad_input);
    CHECK(picked_color.empty());
}

TEST_CASE("a flag is given or not and takes no value", "[choices]") {
    CHECK(run_with({}) == app::done);
    CHECK_FALSE(is_framed);
    CHECK(run_with({"--framed", "--color", "blue"}) == app::done);
    CHECK(is_framed);
    CHECK(picked_color == "blue");
    CHECK(run_with({"--framed", "yes"}) == app::bad_input);
    CHECK(run_with({"--frame"}) == app::bad_input);
}

TEST_CASE("a program shows what it can and refuses the rest", "[choices]") {
    CHECK(run_with({}) == app::done);
    CHECK(shown.empty());
    CHECK(run_with({"--show", "sphere"}) == app::done);
    CHECK(shown == "sphere");
    CHECK(run_with({"--show", "normal"}) == app::bad_input);
    CHECK(run_with({"--show", ""}) == app::bad_input);
}
