#pragma once
// The page to share, out/mine.html: the learner's final picture, what passes, and how long it took.

#include <companion/model/state.hpp>
#include <companion/pages/certificate.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace companion {

// The time from the first passed check to the last, as far as the companion recorded it.
struct TimeTaken {
    std::int64_t first = 0, last = 0;  // in seconds since 1970; 0: nothing has passed
    int days = 0;                      // days on which something passed for the first time
    int unknown = 0;                   // how many answers pass without a recorded time
};
TimeTaken time_taken(const std::vector<std::int64_t>& first_passed);

// The days from `first` to `last`, both included: "50 days" from 2030-01-01 to 2030-02-19.
int days_between(std::int64_t first, std::int64_t last);

struct ChapterStanding {
    Chapter chapter;
    int done = 0, exercises = 0, stars = 0, open_stars = 0;
    std::int64_t finished = 0;  // when its last exercise first passed; 0: not yet, or unknown
};

// The page leaves out whatever is missing or unknown.
struct SharedPage {
    std::string date;     // of the day when the page was made
    std::string picture;  // the bytes of a PNG
    std::string caption;  // whose code drew it
    std::string scene;    // what the picture shows
    std::vector<ChapterStanding> chapters;
    OwnRecord own;  // how the learner's own program was judged
    TimeTaken time;
    std::optional<Certificate> certificate;
};

// Collects what the companion knows; builds and draws nothing.
SharedPage collect_shared_page(const Course& course);

// The page, in one file.
std::string shared_page_html(const SharedPage& page);

}  // namespace companion
