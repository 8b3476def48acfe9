#include <app/run.hpp>
#include <optional>

#include "checkpoint.hpp"
#include "temporary_folder.hpp"

namespace {

// What a program that has a choice of colors was asked for; nothing if it refused its words.
std::optional<app::Settings> ran_with(std::vector<const char*> arguments) {
    const checkpoint::TemporaryFolder folder;
    const std::string out = folder.file("a.ppm");
    arguments.insert(arguments.begin(), {"test", "--quiet", "--out", out.c_str()});
    std::optional<app::Settings> seen;
    const int code = app::run(static_cast<int>(arguments.size()), arguments.data(),
                              {.name = "test",
                               .about = "",
                               .defaults = {},
                               .render =
                                   [&](const app::Settings& settings, app::Progress&) {
                                       seen = settings;
                                       return app::Picture{rt::Image{1, 1}};
                                   },
                               .study = nullptr,
                               .choices = {{"color", "What it is painted with", {"red", "blue"}},
                                           {"brush", "How", {"dry", "wet"}}},
                               .flags = {{"framed", "With a frame around it"}},
                               .shows = {"distance", "sphere"}});
    CHECK(code == (seen ? app::done : app::bad_input));
    return seen;
}

}  // namespace

TEST_CASE("a program has choices of its own and their first word is the default", "[choices]") {
    CHECK(ran_with({}).value().choice("color") == "red");
    const app::Settings blue = ran_with({"--color", "blue"}).value();
    CHECK(blue.choice("color") == "blue");
    CHECK(blue.choice("brush") == "dry");
    CHECK_THROWS(blue.choice("shade"));
}

TEST_CASE("a choice takes only its own words", "[choices]") {
    CHECK_FALSE(ran_with({"--color", "green"}));
    CHECK_FALSE(ran_with({"--color", "wet"}));
    CHECK_FALSE(ran_with({"--color"}));
    CHECK_FALSE(ran_with({"--color", ""}));
    CHECK_FALSE(ran_with({"--shade", "red"}));
}

TEST_CASE("a flag is given or not and takes no value", "[choices]") {
    CHECK(ran_with({}).value().given.count("framed") == 0);
    const app::Settings both = ran_with({"--framed", "--color", "blue"}).value();
    CHECK(both.given.count("framed") == 1);
    CHECK(both.choice("color") == "blue");
    CHECK_FALSE(ran_with({"--framed", "yes"}));
    CHECK_FALSE(ran_with({"--frame"}));
}

TEST_CASE("a program shows what it can and refuses the rest", "[choices]") {
    CHECK(ran_with({}).value().show.empty());
    CHECK(ran_with({"--show", "sphere"}).value().show == "sphere");
    CHECK_FALSE(ran_with({"--show", "normal"}));
    CHECK_FALSE(ran_with({"--show", ""}));
}
