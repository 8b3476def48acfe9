#include <algorithm>
#include <app/files.hpp>
#include <cmath>
#include <companion/check/counts.hpp>
#include <companion/compare/comparison_sheet.hpp>
#include <companion/live/book_file.hpp>
#include <companion/live/page.hpp>
#include <companion/model/hints.hpp>
#include <companion/model/progress.hpp>
#include <companion/model/state.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <cstdlib>
#include <live_files.hpp>
#include <nlohmann/json.hpp>
#include <rt/image_file.hpp>
#include <utility>

namespace companion {
namespace {

using nlohmann::json;

// A text for a terminal as parts, each with the name of its color.
json colored_parts(const std::string& text) {
    static const std::map<std::string, std::string> colors{
        {"32", "green"}, {"31", "red"}, {"33", "yellow"}, {"1", "bold"}, {"2", "dim"}};
    json parts = json::array();
    std::string color;
    for (std::size_t at = 0; at < text.size();) {
        const auto escape = text.find("\033[", at);
        const std::string plain = text.substr(at, escape - at);
        if (!plain.empty()) parts.push_back({color, plain});
        if (escape == std::string::npos) break;
        const auto end = text.find('m', escape);
        if (end == std::string::npos) break;
        const auto known = colors.find(text.substr(escape + 2, end - escape - 2));
        color = known == colors.end() ? "" : known->second;
        at = end + 1;
    }
    return parts;
}

fs::path reading_file(const Course& course) {
    return private_folder(course) / "reading";
}

// Where the learner was in the book: the address and the title of the page.
json place_in_book(const Course& course) {
    const std::string place = app::read_bytes(reading_file(course)).value_or("");
    const std::string title = book_title(course, place.substr(0, place.find('#')));
    if (title.empty()) return nullptr;
    return {{"link", "book/" + place}, {"title", title}};
}

std::string contract_of(const Course& course, const Exercise& exercise) {
    std::string text;
    for (const fs::path& file : exercise.files) {
        const std::string contract = core_contract(shipped_stub(course, file));
        if (!contract.empty()) text += (text.empty() ? "" : "\n") + contract;
    }
    return text;
}

json hints_shown(const Course& course, const State& state, const Exercise& exercise) {
    std::vector<std::string> all = hints_in_view(course, exercise);
    const std::size_t count = all.size();
    const auto known = state.exercises.find(exercise.id);
    const int shown = known == state.exercises.end() ? 0 : known->second.hints;
    all.resize(std::clamp<std::size_t>(static_cast<std::size_t>(std::max(0, shown)), 0, count));
    for (std::string& hint : all) hint = plain_hint(hint);
    return {{"shown", all}, {"count", count}};
}

std::optional<Picture> picture_in_out(const Course& course, const char* name) try {
    return parse_ppm(read_file(course.out() / name));
} catch (const std::exception&) {
    return {};
}

}  // namespace

LivePage::LivePage(const Course& course)
    : course_{course},
      pictures_{course},
      facts_{std::make_unique<json>()},
      server_{[this](const Request& request) { return answer(request); }} {
    renew();
}
LivePage::~LivePage() = default;

void LivePage::begin(const Exercise& exercise, const std::string& next) {
    title_ = exercise.id + ' ' + exercise.title;
    current_ = exercise;
    graft_.reset();
    next_ = next;
    verdict_.clear();
    is_checking_ = true;
    show_counts({});
    publish();
}

void LivePage::tell(const std::string& text) {
    verdict_ += text;
    // On a terminal, this takes back what stands in a line so far.
    const std::string back = "\r\033[K";
    for (std::size_t at; (at = verdict_.find(back)) != std::string::npos;) {
        const std::size_t line = verdict_.rfind('\n', at) + 1;  // 0 if there is none
        verdict_.erase(line, at + back.size() - line);
    }
    publish();
}

void LivePage::end() {
    is_checking_ = false;
    show_counts(kept_counts(course_));
    pictures_.look_at(current_->chapter);
    renew();
}

void LivePage::begin_tracer() {
    title_ = "Your tracer";
    verdict_.clear();
    is_checking_ = true;
    show_counts({});
    publish();
}

void LivePage::end_tracer() {
    is_checking_ = false;
    pictures_.show_tracer(picture_in_out(course_, "tracer.ppm"),
                          picture_in_out(course_, "tracer_ours.ppm"));
    show_pictures();
    renew();
}

void LivePage::show_next(const std::string& words, const Exercise& exercise,
                         const std::optional<Chapter>& graft) {
    next_ = words;
    current_ = exercise;
    graft_ = graft;
    if (graft)
        end_tracer();
    else if (title_.empty())
        pictures_.look_at(exercise.chapter);
    renew();
}

void LivePage::renew() {
    *facts_ = facts();
    publish();
}

bool LivePage::has_work() const {
    return is_asked_ || (server_.viewers() > 0 && !pictures_.is_done() && !pictures_.waits());
}

void LivePage::work(const std::function<bool()>& is_over) {
    std::vector<Request> wishes;
    {
        const std::lock_guard lock{showing_};
        wishes.swap(wishes_);
        is_asked_ = false;
    }
    for (const Request& wish : wishes) try {
            obey(wish);
        } catch (const std::exception&) {
            // What cannot be written is not noted.
        }
    if (!wishes.empty()) renew();
    if (!has_work()) return;
    pictures_.step(is_over);
    show_pictures();
    publish();
}

void LivePage::obey(const Request& wish) {
    const auto value = [&](const char* name) {
        const auto found = wish.query.find(name);
        return found == wish.query.end() ? "" : found->second;
    };
    if (wish.path == "hint" && current_ && value("of") == current_->id)
        due_hint(course_, current_->id, hints_in_view(course_, *current_).size());
    if (wish.path == "show") pictures_.show(value("what"));
    if (wish.path == "draw") pictures_.insist();
    if (wish.path == "follow")
        pictures_.follow(std::atoi(value("x").c_str()), std::atoi(value("y").c_str()));
    if (wish.path == "at" && !book_title(course_, value("page")).empty())
        app::replace_file(reading_file(course_), value("page") + '#' + value("section"));
}

void LivePage::show_counts(std::map<std::string, std::string> counts) {
    if (counts == counts_) return;
    counts_ = std::move(counts);
    show_pictures();
}

void LivePage::show_pictures() {
    std::map<std::string, std::string> shown = counts_;
    const auto &mine = pictures_.mine(), &solution = pictures_.solution();
    if (mine) shown["mine"] = rt::encode_png(mean_of({*mine}));
    if (solution) shown["solution"] = rt::encode_png(mean_of({*solution}));
    if (mine && solution && same_size(*mine, *solution))
        shown["difference"] = rt::encode_png(difference_map(*mine, *solution));
    const std::lock_guard lock{showing_};
    if (pictures_.path() != shown_path_) {
        shown_path_ = pictures_.path();
        ++path_number_;
    }
    if (shown == shown_pictures_) return;
    shown_pictures_ = std::move(shown);
    ++picture_number_;
}

void LivePage::publish() {
    json state = *facts_;
    state["verdict"] = colored_parts(verdict_);
    state["checked"] = title_;
    state["checking"] = is_checking_;
    state["next"] = colored_parts(next_);
    state["picture"] = picture();
    // What is no UTF-8 gets a mark in its place.
    std::string now = state.dump(-1, ' ', false, json::error_handler_t::replace);
    {
        const std::lock_guard lock{showing_};
        if (now == shown_state_) return;
        shown_state_ = std::move(now);
    }
    server_.tell_news();
}

json LivePage::facts() const {
    const State known = read_state(course_);
    json ticks = json::array(), passed = json::array();
    for (const Exercise& exercise : exercises(course_)) {
        const Progress progress = progress_of(course_, known, exercise);
        if (passes(progress)) passed.push_back(exercise.id);
        if (!current_ || exercise.chapter.name != chapter_at_hand().name) continue;
        ticks.push_back({{"id", exercise.id},
                         {"title", exercise.title},
                         {"symbol", std::string{symbol(progress)}},
                         {"words", text(progress)},
                         {"passes", passes(progress)}});
    }
    json facts{{"ticks", ticks}, {"passed", passed}, {"reading", place_in_book(course_)}};
    if (!current_) return facts;
    const Chapter& chapter = chapter_at_hand();
    facts["chapter"] = chapter.number() + ' ' + chapter.title;
    if (graft_) {
        facts["exercise"] = "graft " + graft_->number();
        facts["link"] = book_section_of_graft(course_, *graft_);
        return facts;
    }
    facts["exercise"] = current_->id;
    facts["link"] = book_section(course_, *current_);
    facts["contract"] = contract_of(course_, *current_);
    facts["hints"] = hints_shown(course_, known, *current_);
    return facts;
}

json LivePage::picture() const {
    json shown = json::array();
    for (const auto& [name, bytes] : shown_pictures_) shown.push_back(name);
    const Yours& yours = pictures_.yours();
    const bool is_placed =
        !(yours.passing.empty() && yours.failing.empty() && yours.others.empty());
    return {{"number", picture_number_},
            {"shown", shown},
            {"whose", is_placed ? yours.words() : ""},
            {"trouble", pictures_.trouble()},
            {"waits", pictures_.waits()},
            {"seconds", std::lround(pictures_.seconds_to_build())},
            {"words", pictures_.words()},
            {"isOld", pictures_.is_old()},
            {"isFine", pictures_.is_fine()},
            {"isDone", pictures_.is_done()},
            {"shows", pictures_.options().shows},
            {"show", pictures_.shown()},
            {"told", pictures_.told()},
            {"path", pictures_.path().empty() ? 0 : path_number_}};
}

std::optional<Content> LivePage::answer(const Request& request) {
    const std::string& path = request.path;
    if (path.empty()) return Content{"text/html; charset=utf-8", page_html};
    if (path == "page.css")
        return Content{"text/css; charset=utf-8", std::string{palette_css} + page_css};
    if (path == "page.js")
        return Content{"text/javascript; charset=utf-8", std::string{slide_js} + page_js};
    if (path == "beside.js") return Content{"text/javascript; charset=utf-8", beside_js};
    if (path == "book" || path.rfind("book/", 0) == 0)
        return path == "book" ? std::nullopt : book_file(course_, path.substr(5));
    const std::lock_guard lock{showing_};
    if (path == "state") return Content{"application/json", shown_state_};
    if (path == "hint" || path == "show" || path == "draw" || path == "follow" || path == "at") {
        if (wishes_.size() < 100) wishes_.push_back(request);
        is_asked_ = true;
        return Content{"application/json", "{}"};
    }
    if (path == "path.svg" && !shown_path_.empty()) return Content{"image/svg+xml", shown_path_};
    const std::string png = ".png";
    if (path.size() <= png.size() || path.substr(path.size() - png.size()) != png) return {};
    const auto found = shown_pictures_.find(path.substr(0, path.size() - png.size()));
    if (found == shown_pictures_.end()) return {};
    return Content{"image/png", found->second};
}

}  // namespace companion
