#pragma once
#include <string>

namespace companion {

// The text after the first "# " of a document, else nothing.
std::string document_title(const std::string& markdown);

// The first paragraph that is no image of the section with this "## " heading, as one line; nothing
// where there is none.
std::string first_paragraph(const std::string& markdown, const std::string& section);

// A paragraph as HTML: *emphasis*, **strong**, `code`, $formula$ and [links](target). Whatever else
// it holds appears as it is. Links to other files start at `base`.
std::string to_html(const std::string& paragraph, const std::string& base);

// Text as HTML shows it.
std::string escape_html(const std::string& text);

}  // namespace companion
