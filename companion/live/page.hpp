#pragma once
// The page that `watch` shows in a browser beside the terminal.

#include <atomic>
#include <companion/live/pictures.hpp>
#include <companion/live/server.hpp>
#include <companion/model/exercise.hpp>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>

namespace companion {

// Only the thread that made it may call its functions.
class LivePage {
  public:
    // Throws app::Failure if no port can be had.
    explicit LivePage(const Course& course);
    ~LivePage();

    std::string address() const { return server_.address(); }

    // A check of this exercise begins, which comes next while it does not pass; what the terminal
    // says of it; it has ended. Then the picture of its chapter is drawn. What the check counted,
    // and what was expected, are pictures in out/ if it failed by that: see counts.hpp.
    void begin(const Exercise& exercise, const std::string& next);
    void tell(const std::string& text);
    void end();

    // The same for the learner's tracer. Its picture, and ours, are in out/ if they were drawn.
    void begin_tracer();
    void end_tracer();

    // What the terminal says about what to do next, and the exercise, which may be the same as
    // before. If a chapter is named, its graft comes first.
    void show_next(const std::string& words, const Exercise& exercise,
                   const std::optional<Chapter>& graft = {});

    // Shows again what may have changed in the course's files. That takes longer than a learner
    // should wait for a verdict.
    void renew();

    // Whether there is something to do: what was asked on the page or, while somebody looks, a
    // picture to draw.
    bool has_work() const;
    bool is_asked() const { return is_asked_; }
    // Does a part of it, which ends early if `is_over` says so.
    void work(const std::function<bool()>& is_over);

  private:
    std::optional<Content> answer(const Request& request);
    void obey(const Request& wish);
    nlohmann::json facts() const;
    const Chapter& chapter_at_hand() const { return graft_ ? *graft_ : current_->chapter; }
    nlohmann::json picture() const;
    void publish();
    void show_pictures();
    void show_counts(std::map<std::string, std::string> counts);

    const Course& course_;
    LivePictures pictures_;
    std::string verdict_, next_;
    std::string title_;  // of what was checked last
    std::optional<Exercise> current_;
    std::optional<Chapter> graft_;  // which comes before the current exercise
    bool is_checking_ = false;
    std::unique_ptr<nlohmann::json> facts_;  // what the course's files say

    // What the server's threads see.
    std::mutex showing_;
    std::string shown_state_;
    std::map<std::string, std::string> shown_pictures_;  // PNG files by their names
    std::vector<Request> wishes_;
    std::atomic<bool> is_asked_ = false;
    std::map<std::string, std::string> counts_;  // of them, those of the last check's counts
    std::string shown_path_;                     // of a sample's light, an SVG file
    int picture_number_ = 0, path_number_ = 0;

    Server server_;  // the last, so that it ends first
};

}  // namespace companion
