#pragma once
// The web book, out/book, as the server shows it.

#include <companion/live/server.hpp>
#include <companion/model/exercise.hpp>

namespace companion {

// A file of the book; nothing if there is none, or if a link leads to it from the book. Pages get a
// link back, and ticks.
std::optional<Content> book_file(const Course& course, const std::string& path);

// "book/03-sphere.html#032-ray-meets-sphere", the section of an exercise; empty if the book is not
// made. The same for a chapter's graft.
std::string book_section(const Course& course, const Exercise& exercise);
std::string book_section_of_graft(const Course& course, const Chapter& chapter);

// The title of a page of the book; empty if there is no such page.
std::string book_title(const Course& course, const std::string& page);

}  // namespace companion
