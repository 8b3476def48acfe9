#include <companion/check/known_mistakes.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/shown_verdict.hpp>
#include <companion/system/terminal.hpp>

namespace companion {
namespace {

void print_mistakes(const Course& course, const Checked& checked, const IsOver& is_over) {
    tell_what_it_looks_like(
        course, checked.exercise, checked.tests(),
        [](const Mistake& mistake, Joins joins) { print(looks_like(mistake, joins)); }, is_over);
}

}  // namespace

void print_details(const Course& course, const Checked& checked, const IsOver& is_over) {
    print('\n' + details(checked));
    print_mistakes(course, checked, is_over);
    print(where_to_read(checked));
}

void print_open_stars(const Course& course, const Checked& checked) {
    const std::string text = open_stars(checked);
    if (text.empty()) return;
    print('\n' + text);
    print_mistakes(course, checked, [] { return false; });
    print(where_to_read(checked));
}

}  // namespace companion
