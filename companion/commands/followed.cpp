#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/commands/followed.hpp>
#include <companion/follow/trail_drawing.hpp>
#include <companion/system/files.hpp>
#include <companion/system/terminal.hpp>
#include <regex>
#include <rt/image_file.hpp>

namespace companion {
namespace {

std::string text_of(const Followed& followed) {
    return std::to_string(followed.column) + ',' + std::to_string(followed.row);
}

// Why the program told nothing about the pixel, although it ended as it should.
[[noreturn]] void refuse(const FollowRequest& request) {
    const Picture picture = parse_ppm(read_file(request.picture));
    const std::string pixel = text_of(request.followed);
    if (request.followed.column >= picture.width || request.followed.row >= picture.height)
        throw app::UsageError("--follow " + pixel +
                              " is outside of the picture: its columns are 0 to " +
                              std::to_string(picture.width - 1) + ", and its rows 0 to " +
                              std::to_string(picture.height - 1));
    throw app::UsageError("--follow " + pixel +
                          ": the program sends no ray through this pixel, or many at once; only "
                          "single rays can be followed");
}

TrailPicture picture_below(const FollowRequest& request) {
    try {
        const WaitingLine waiting{"drawing the picture below the path"};
        const Picture picture = request.draw();
        return {rt::encode_png(mean_of({picture})), picture.width, picture.height};
    } catch (const app::Failure& failed) {
        print("There is no picture below the path: " + std::string{failed.what()} + '\n');
        return {};
    }
}

}  // namespace

Followed followed_in(const std::string& text) {
    std::smatch part;
    if (!std::regex_match(text, part, std::regex{"(\\d{1,6}),(\\d{1,6})(,(\\d{1,6}))?"}))
        throw app::UsageError(
            "--follow takes a pixel's column and row, and perhaps the number of a "
            "sample: --follow 400,225 or --follow 400,225,3");
    return {std::stoi(part[1]), std::stoi(part[2]), part[4].matched ? std::stoi(part[4]) : 0};
}

int follow(const Course& course, const FollowRequest& request) {
    const auto [trail, result] =
        record(request.followed,
               {.command = request.command, .folder = course.root, .output = Output::errors_shown});
    const std::string sample = std::to_string(request.followed.sample);
    if (!has_step(trail, "ray")) {
        if (has_step(trail, "pixel"))
            throw app::UsageError(
                "--follow: there is no sample " + sample + ": those of the pixel " +
                text_of(request.followed) + " are 0 to " +
                std::to_string(static_cast<int>(trail.front().number("samples")) - 1));
        if (result.ok()) refuse(request);
    } else {
        print(bold("Pixel " + text_of(request.followed) + ", sample " + sample) + '\n' +
              in_words(trail));
    }
    if (result.signal != 0) print("     the program crashed here: " + how_it_ended(result) + '\n');
    if (has_step(trail, "ray")) {
        app::make_folder(request.drawing.parent_path());
        app::replace_file(request.drawing, drawn(trail, picture_below(request)));
        print("Drawn: " + course.relative(request.drawing) + '\n');
    }
    return result.signal != 0 ? app::could_not : result.exit_code;
}

}  // namespace companion
