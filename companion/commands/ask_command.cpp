#include <unistd.h>

#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/questions.hpp>
#include <companion/model/state.hpp>
#include <companion/system/files.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>
#include <iostream>

namespace companion {
namespace {

// A question that is not answered yet, and its number in its chapter.
struct Open {
    Chapter chapter;
    Question question;
    std::size_t number = 0, of = 0;
};

std::vector<Open> open_questions(const Course& course, const std::vector<Chapter>& chapters) {
    const State state = read_state(course);
    std::vector<Open> open;
    for (const Chapter& chapter : chapters) {
        const std::vector<Question> all = questions(course, chapter);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto known = state.answers.find(all[i].key());
            if (known == state.answers.end() || !known->second.right)
                open.push_back({chapter, all[i], i + 1, all.size()});
        }
    }
    return open;
}

std::string letter(std::size_t choice) {
    return std::string(1, static_cast<char>('a' + static_cast<int>(choice))) + ") ";
}

// A copy of a question's picture whose name does not give the answer away.
fs::path neutral_picture(const Course& course, const Open& open) {
    const fs::path copy = fs::path{"out"} / ("question-" + open.chapter.number() + ".png");
    fs::create_directories(course.root / "out");
    app::replace_file(course.root / copy, read_file(course.root / open.question.picture));
    return copy;
}

std::string right_answer(const Question& question) {
    if (!question.choices.empty())
        return letter(question.right_choice) + question.choices[question.right_choice];
    char text[32];
    std::snprintf(text, sizeof text, "%g", question.number);
    return text;
}

void print_question(const Course& course, const Open& open) {
    const Question& question = open.question;
    print('\n' +
          bold("Chapter " + open.chapter.number() + ", question " + std::to_string(open.number) +
               " of " + std::to_string(open.of)) +
          " (" + question.kind + ")\n" + wrapped(question.ask, "  "));
    if (!question.picture.empty())
        print("  Look at " + neutral_picture(course, open).string() + '\n');
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        print("    " + letter(i) + question.choices[i] + '\n');
}

std::string what_fits(const Question& question) {
    return question.choices.empty() ? "a number, such as 0.75 or 3/4" : "one of the letters";
}

// Judges and remembers an answer, and prints the verdict: after the first wrong answer a hint,
// after the second the reason. Such a question is asked again another day.
Reply take(const Course& course, const Question& question, const std::string& answer, bool again) {
    const Reply reply = reply_to(question, answer);
    if (reply == Reply::not_understood) {
        print("  Answer with " + what_fits(question) + ".\n");
        return reply;
    }
    change_state(course, [&](State& state) {
        Answered& answered = state.answers[question.key()];
        answered.right = reply == Reply::right;
        answered.answer = answer;
        ++answered.tries;
    });
    if (reply == Reply::right)
        print("  " + green("Right.") + '\n' + wrapped(question.because, "  "));
    else if (!again)
        print("  " + yellow("Not yet.") + '\n' + wrapped(question.nudge, "  "));
    else
        print("  " + red("No.") + " The right answer is " + right_answer(question) + '\n' +
              wrapped(question.because, "  "));
    return reply;
}

// Judges the one answer given on the command line.
int answer_one(const Course& course, const Open& open, const std::string& answer) {
    if (reply_to(open.question, answer) == Reply::not_understood)
        throw app::UsageError("ask --answer: question " + std::to_string(open.number) +
                              " of chapter " + open.chapter.number() + " takes " +
                              what_fits(open.question) + ", not '" + answer + '\'');
    print_question(course, open);
    const State state = read_state(course);
    const auto known = state.answers.find(open.question.key());
    const bool again = known != state.answers.end() && known->second.tries % 2 == 1;
    return take(course, open.question, answer, again) == Reply::right ? app::done : app::could_not;
}

// False at the end of the input.
bool ask_until_told(const Course& course, const Open& open) {
    print_question(course, open);
    for (int wrong = 0; wrong < 2;) {
        print("> ");
        std::string line;
        if (!std::getline(std::cin, line)) return false;
        if (line.empty()) return true;  // the next one
        const Reply reply = take(course, open.question, line, wrong == 1);
        if (reply == Reply::right) return true;
        wrong += reply == Reply::wrong;
    }
    return true;
}

}  // namespace

int ask(const Course& course, const Given& given) {
    std::vector<Chapter> chosen = chapters(course);
    if (given.named) chosen = {find_chapter(course, *given.named)};
    const std::vector<Open> open = open_questions(course, chosen);
    if (open.empty()) {
        print("All questions" + (given.named ? " of chapter " + chosen[0].number() : "") +
              " are answered.\n");
        return app::done;
    }
    if (given.has("--answer"))
        return answer_one(course, open.front(), given.options.at("--answer"));
    print(dim("Press Enter alone to skip a question, Ctrl-D to stop.\n"));
    for (const Open& one : open)
        if (!ask_until_told(course, one)) {
            print("\n");
            if (!::isatty(STDIN_FILENO))
                print("To answer: ./course ask " + one.chapter.number() + " --answer ANSWER\n");
            return app::done;
        }
    return app::done;
}

}  // namespace companion
