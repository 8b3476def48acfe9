#include <companion/pages/gallery.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using checkpoint::TemporaryFolder;
using checkpoint::write_file;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const companion::Chapter sphere{.name = "03_sphere",
                                .title = "The <sphere>",
                                .text = "docs/03-sphere.md",
                                .caption = "A \"ball\"."};

}  // namespace

TEST_CASE("the gallery shows what there is of a chapter", "[gallery]") {
    const TemporaryFolder folder;
    const companion::Course here{folder.path(), folder / "build"};
    write_file(folder / "docs/03-sphere.md", "text");
    write_file(folder / "out/03_sphere.png", "");
    write_file(folder / "out/study/03_sphere.csv",
               "study,variant,precision,x,x_name,error,error_name,cost,cost_name\n"
               "Far away,v,double,1,n,0,ulp,1,ns\n");
    write_file(folder / "out/study/03_sphere-far-away.svg", "");
    const std::string html =
        companion::gallery_html({companion::collect(here, sphere, "in 2 s")}, false);
    CHECK(holds(html, "<h2>Chapter 03: The &lt;sphere&gt;</h2>"));
    CHECK(holds(html, "<p>A &quot;ball&quot;.</p>"));
    CHECK(holds(html, "src=\"03_sphere.png\""));
    CHECK(holds(html, "in 2 s"));
    CHECK(holds(html, "href=\"../docs/03-sphere.md\""));
    CHECK(holds(html, "href=\"study/03_sphere.csv\""));
    CHECK(
        holds(html, "src=\"study/03_sphere-far-away.svg\" alt=\"A plot of the study: Far away\""));
    CHECK(holds(html, "<figcaption>Far away</figcaption>"));
    CHECK_FALSE(holds(html, "book/index.html"));
    CHECK(holds(companion::gallery_html({}, true), "href=\"book/index.html\""));
    CHECK_FALSE(holds(html, "http:"));
    CHECK_FALSE(holds(html, "https:"));
}

TEST_CASE("the gallery shows the plots of the texts where nothing was measured", "[gallery]") {
    const TemporaryFolder folder;
    const companion::Course here{folder.path(), folder / "build"};
    write_file(folder / "docs/plots/03_sphere-far-away.svg", "");
    write_file(folder / "docs/plots/04_normals_aa-samples.svg", "");
    write_file(folder / "docs/studies/03_sphere.csv",
               "study,variant,precision,x,x_name,error,error_name,cost,cost_name\n"
               "Far away,v,double,1,n,0,ulp,1,ns\n");
    write_file(
        folder / "docs/studies/captions.json",
        R"({"axes": {}, "studies": {"03_sphere": {"Far away": {"claim": "All is <right>"}}}})");
    const std::string html = companion::gallery_html({companion::collect(here, sphere, "")}, false);
    CHECK(holds(html, "alt=\"All is &lt;right&gt;\""));
    CHECK(holds(html, "src=\"../docs/plots/03_sphere-far-away.svg\""));
    CHECK(holds(html, "./course study"));
    CHECK_FALSE(holds(html, "04_normals_aa"));
}

TEST_CASE("the gallery does without what is missing", "[gallery]") {
    const TemporaryFolder folder;
    const companion::Course here{folder.path(), folder / "build"};
    const std::string html = companion::gallery_html({companion::collect(here, sphere, "")}, false);
    CHECK(holds(html, "<h2>Chapter 03: The &lt;sphere&gt;</h2>"));
    CHECK(holds(html, "No picture"));
    CHECK_FALSE(holds(html, "<img"));
    CHECK_FALSE(holds(html, "03-sphere.md"));
}
