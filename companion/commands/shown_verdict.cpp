#include <companion/check/counts.hpp>
#include <companion/check/known_mistakes.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/shown_verdict.hpp>

namespace companion {
namespace {

void print_mistakes(const Course& course, const Checked& checked, const IsOver& is_over,
                    const std::function<void(const std::string&)>& say) {
    tell_what_it_looks_like(
        course, checked.exercise, checked.tests(),
        [&](const Mistake& mistake, Joins joins) { say(looks_like(mistake, joins)); }, is_over);
}

}  // namespace

void print_details(const Course& course, const Checked& checked, const IsOver& is_over,
                   const std::function<void(const std::string&)>& say) {
    const std::string telling = most_telling(course, checked.exercise, checked.tests());
    say('\n' + details(checked, telling));
    say(keep_counts(course, checked.tests(), telling));
    print_mistakes(course, checked, is_over, say);
    say(where_to_read(checked));
}

void print_open_stars(const Course& course, const Checked& checked) {
    const std::string text = open_stars(checked);
    if (text.empty()) return;
    print('\n' + text);
    print_mistakes(
        course, checked, [] { return false; }, print);
    print(where_to_read(checked));
}

}  // namespace companion
