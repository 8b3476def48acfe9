#include <companion/pages/html.hpp>

#include "catch.hpp"

using companion::escape_html;

TEST_CASE("text appears as it is, and harms nobody", "[html]") {
    CHECK(escape_html("1 < 2 & \"x\" > 0") == "1 &lt; 2 &amp; &quot;x&quot; &gt; 0");
    CHECK(escape_html("2 * 3, `open, [not a link], $5") == "2 * 3, `open, [not a link], $5");
    CHECK(escape_html("<script>") == "&lt;script&gt;");
    CHECK(escape_html("") == "");
}
