#pragma once
#include <companion/model/course.hpp>
#include <companion/pages/studies.hpp>
#include <string>
#include <vector>

namespace companion {

// One chapter's part of the gallery. Whatever is missing (a picture that failed, a text that is not
// written yet) is left out.
struct Exhibit {
    Chapter chapter;
    std::string rendered;  // how the picture was made, such as "960x540 pixels in 0.12 s"
    bool has_picture = false, has_text = false, has_table = false;
    std::vector<Plot> plots;
};

// Collects what out/ and docs/ hold about a chapter.
Exhibit collect(const Course& course, const Chapter& chapter, const std::string& rendered);

// The page out/index.html, with paths relative to out/, and a link to the web book if it exists.
std::string gallery_html(const std::vector<Exhibit>& exhibits, bool with_book);

}  // namespace companion
