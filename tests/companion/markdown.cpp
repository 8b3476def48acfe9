#include <companion/pages/markdown.hpp>

#include "catch.hpp"

using companion::document_title;
using companion::first_paragraph;
using companion::to_html;

namespace {

const std::string document = R"(# Chapter 03: The sphere

Before.

## What you will see

![A sphere](images/03_sphere.png)

Moons in *sand* and lavender,
over two lines.

A second paragraph.

## The mathematics

Not this.
)";

}  // namespace

TEST_CASE("the title is the first heading", "[markdown]") {
    CHECK(document_title(document) == "Chapter 03: The sphere");
    CHECK(document_title("no heading") == "");
}

TEST_CASE("the caption is the first paragraph after the image", "[markdown]") {
    CHECK(first_paragraph(document, "What you will see") ==
          "Moons in *sand* and lavender, over two lines.");
    CHECK(first_paragraph(document, "Hard cases") == "");
    CHECK(first_paragraph("## What you will see\n\n![x](y)\n\n## Next\n\nNo.",
                          "What you will see") == "");
    CHECK(first_paragraph("", "What you will see") == "");
}

TEST_CASE("a paragraph becomes HTML", "[markdown]") {
    CHECK(to_html("a *b* **c** `d<e` $x^2$", "") ==
          "a <em>b</em> <strong>c</strong> <code>d&lt;e</code> <i>x^2</i>");
    CHECK(to_html("`*not*`", "") == "<code>*not*</code>");
    CHECK(to_html("[*here*](02-camera.md#x)", "../docs/") ==
          "<a href=\"../docs/02-camera.md#x\"><em>here</em></a>");
    CHECK(to_html("[there](https://example.org)", "../docs/") ==
          "<a href=\"https://example.org\">there</a>");
}

TEST_CASE("what is no Markdown appears as it is, and harms nobody", "[markdown]") {
    CHECK(to_html("1 < 2 & \"x\" > 0", "") == "1 &lt; 2 &amp; &quot;x&quot; &gt; 0");
    CHECK(to_html("2 * 3, `open, [not a link], $5", "") == "2 * 3, `open, [not a link], $5");
    CHECK(to_html("<script>", "") == "&lt;script&gt;");
    CHECK(to_html("", "") == "");
}
