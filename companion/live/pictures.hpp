#pragma once
// A chapter's picture by all of the learner's code, right or wrong, and by the solution's: first
// coarse, then finer.

#include <companion/check/yours.hpp>
#include <companion/compare/program_pictures.hpp>
#include <companion/follow/record.hpp>
#include <functional>
#include <map>

namespace companion {

class LivePictures {
  public:
    explicit LivePictures(const Course& course) : course_{course} {}

    // Draws this chapter anew, because the learner's code has changed.
    void look_at(const Chapter& chapter);
    // Draws in the false colors of --show; empty: the picture itself.
    void show(const std::string& word);
    // Draws, now and at each later save in this chapter, although building the program takes long.
    void insist();
    // Shows pictures that are there already: of the learner's tracer, and of ours if there is one.
    void show_tracer(std::optional<Picture> mine, std::optional<Picture> ours);

    // Tells what the light of a pixel's first sample does, in the picture that is shown.
    void follow(int column, int row);

    bool is_done() const { return now_ == done && !followed_; }
    // Takes the next step, at low priority. If `is_over` says so before it ends, the step is taken
    // anew the next time.
    void step(const std::function<bool()>& is_over);

    // What there is so far.
    const Yours& yours() const { return yours_; }
    const std::string& trouble() const { return trouble_; }  // why there is no picture
    bool waits() const { return now_ == waiting; }           // until the learner insists
    // The processor time that it last took to build this chapter's program; 0: never built.
    double seconds_to_build() const;
    const std::optional<Picture>& mine() const { return mine_; }
    const std::optional<Picture>& solution() const { return solution_; }
    bool is_fine() const { return is_fine_; }
    // Whether the pictures are from before.
    bool is_old() const { return now_ >= placing && now_ <= coarse; }
    const DrawingOptions& options() const { return options_; }  // of the program
    const std::string& shown() const { return show_; }
    // Whether the two pictures are the same, in words; empty if one is missing.
    const std::string& words() const { return words_; }

    // What the light does, in words and as an SVG file; empty if nobody asked.
    const std::string& told() const { return told_; }
    const std::string& path() const { return path_; }

  private:
    // What comes next.
    enum Stage { done, placing, building, waiting, coarse, coarse_solution, fine };

    void build(const std::function<bool()>& is_over);
    void draw(bool is_fine, const std::function<bool()>& is_over);
    void follow_light(const std::function<bool()>& is_over);
    void forget_light();
    void begin(Stage stage);
    fs::path program(const char* whose) const;
    fs::path seconds_file() const;
    std::optional<DrawingOptions> finer() const;
    std::string compared() const;
    Picture solutions_picture(const DrawingOptions& options);

    const Course& course_;
    Chapter chapter_;
    Stage now_ = done;
    std::string show_;
    bool insists_ = false;
    Yours yours_;
    std::string trouble_, words_;
    std::optional<Picture> mine_, solution_;
    bool is_fine_ = false;
    DrawingOptions options_;        // the program's own
    DrawingOptions shown_options_;  // of the picture that is shown
    std::optional<Followed> followed_;
    std::string told_, path_;
    DrawingOptions coarse_options_;  // of the first picture
    double spent_ = 0,
           coarse_ = 0;  // seconds of processor time since the save, and of the coarse picture
    std::map<std::string, Picture> drawn_;  // the solution's, by its options
};

}  // namespace companion
