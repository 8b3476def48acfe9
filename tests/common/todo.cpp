#include <memory>
#include <optional>
#include <rt/color.hpp>
#include <rt/mat4.hpp>
#include <rt/sphere.hpp>
#include <rt/todo.hpp>
#include <tuple>
#include <variant>
#include <vector>

#include "checkpoint.hpp"

namespace {

struct Big {
    explicit Big(int);
    std::string text;
};

int line_of_stub = 0;
double stub(double a, const std::vector<int>& b) {
    line_of_stub = __LINE__ + 1;
    return rt::todo("99.1", a, b);
}
void no_value(int n) {
    rt::todo("99.2", n);
}
int no_arguments() {
    return rt::todo("99.3");
}

template <class T>
T unwritten() {
    return rt::todo("99.4");
}

template <class... T>
void all_throw() {
    (..., [] { CHECK_THROWS_AS(unwritten<T>(), rt::NotImplemented); }());
}

std::string message(void (*work)()) {
    try {
        work();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace

TEST_CASE("todo names the exercise, the file and the line of its stub", "[todo]") {
    const std::string said = message([] { stub(1, {}); });
    INFO(said);
    CHECK(said.find("exercise 99.1 is still to be written: ") == 0);
    CHECK(said.find("todo.cpp:" + std::to_string(line_of_stub) + ",") != std::string::npos);
    CHECK(said.find(", section 99.1") != std::string::npos);
    CHECK(said.find('\n') == std::string::npos);
}

TEST_CASE("the message leads from the stub to its text, wherever the course lies", "[todo]") {
    const rt::NotImplemented error("03.1",
                                   "/home/exercises/me/exercises/03_sphere/rt/quadratic.hpp", 12);
    CHECK(
        std::string(error.what()) ==
        "exercise 03.1 is still to be written: exercises/03_sphere/rt/quadratic.hpp:12, explained "
        "in docs/03-sphere.md, section 03.1");
    CHECK(error.exercise() == "03.1");
    const rt::NotImplemented longer("04.2", "exercises/04_normals_aa/rt/lambert.hpp", 1);
    CHECK(std::string(longer.what()).find("docs/04-normals_aa.md") != std::string::npos);
}

TEST_CASE("todo stands in for a function of any type", "[todo]") {
    CHECK_THROWS_AS(no_value(1), rt::NotImplemented);
    CHECK_THROWS_AS(no_arguments(), rt::NotImplemented);
    all_throw<bool, int, float, double, rt::Vec3, rt::Color, rt::Mat4, rt::Sphere>();
    all_throw<std::optional<int>, std::optional<rt::Vec3>, std::vector<int>, std::string,
              std::vector<std::vector<rt::Vec3>>, std::pair<int, int>, std::tuple<int, rt::Vec3>,
              std::variant<int, rt::Vec3>, std::unique_ptr<int>, std::shared_ptr<Big>, Big, Big*>();
}

TEST_CASE("an exercise that is to be written is a logic_error", "[todo]") {
    CHECK_THROWS_AS(no_arguments(), std::logic_error);
}
