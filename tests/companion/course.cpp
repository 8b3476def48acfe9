#include <app/errors.hpp>
#include <companion/model/course.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using checkpoint::TemporaryFolder;
using checkpoint::write_file;
using companion::Chapter;

TEST_CASE("a chapter's name tells where its parts are", "[course]") {
    const Chapter chapter{"04_normals_aa"};
    CHECK(chapter.number() == "04");
    CHECK(chapter.document() == "04-normals_aa.md");
    CHECK(chapter.picture() == "04_normals_aa.png");
    CHECK(chapter.table() == "04_normals_aa.csv");
}

TEST_CASE("the chapters are those that the build wrote down", "[course]") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(companion::chapters({folder.path(), folder.path()}), app::Failure);
    write_file(folder / "chapters.txt", "01_vectors\n02_camera\n");
    const auto all = companion::chapters({folder.path(), folder.path()});
    REQUIRE(all.size() == 2);
    CHECK(all[1].name == "02_camera");
}

TEST_CASE("a chapter is found by whatever a person calls it", "[course]") {
    const std::vector<Chapter> all{{"01_vectors"}, {"02_camera"}, {"04_normals_aa"}};
    for (const char* const name : {"2", "02", "02_camera", "camera"})
        CHECK(companion::find_chapter(all, name).name == "02_camera");
    CHECK(companion::find_chapter(all, "normals_aa").name == "04_normals_aa");
    for (const char* const name : {"", "3", "0", "x", "2_camera", "../02_camera"})
        CHECK_THROWS_AS(companion::find_chapter(all, name), app::UsageError);
}
