#pragma once
// What rank 0 sends to the other ranks: the scene, and which part of the picture to draw.

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <filesystem>
#include <rt/scene.hpp>
#include <rt/turned_view.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "final_scene.hpp"
#include "open_meshed.hpp"
#include "scene_value.hpp"

namespace cluster {

namespace fs = std::filesystem;

// A file's name within the scene's folder, and its bytes. The scene file has no name.
struct NamedFile {
    std::string name, bytes;
};

struct Job {
    bool is_none = false;  // nothing is drawn: the options were wrong, or asked for help
    rt::RenderSettings settings;
    int frame = 0, frames = 1;     // of a turntable
    int tile_side = 32;            // pixels
    int threads = 0;               // of each rank; 0: as many as its machine has
    bool in_slices = false;        // a slice of the rows for each rank instead of tiles
    int count = 0;                 // how many tiles there are to draw
    std::vector<int> tiles;        // their numbers; empty if all tiles are to be drawn
    std::vector<NamedFile> files;  // the scene file and those that it names; none: the final scene
};

// A job as bytes, and back.
inline std::string packed(const Job& job) {
    std::ostringstream out;
    const auto& [width, height, samples, depth, seed] = job.settings;
    for (const std::uint64_t number :
         {std::uint64_t{job.is_none}, std::uint64_t(width), std::uint64_t(height),
          std::uint64_t(samples), std::uint64_t(depth), seed, std::uint64_t(job.frame),
          std::uint64_t(job.frames), std::uint64_t(job.tile_side), std::uint64_t(job.threads),
          std::uint64_t{job.in_slices}, std::uint64_t(job.count), std::uint64_t{job.tiles.size()}})
        out << number << ' ';
    for (const int tile : job.tiles) out << tile << ' ';
    out << job.files.size() << '\n';
    for (const auto& [name, bytes] : job.files)
        out << name.size() << ' ' << bytes.size() << '\n' << name << bytes;
    return out.str();
}

inline Job unpacked(std::string bytes) {
    std::istringstream in{std::move(bytes)};
    Job job;
    auto& [width, height, samples, depth, seed] = job.settings;
    std::size_t tiles = 0, files = 0;
    in >> job.is_none >> width >> height >> samples >> depth >> seed >> job.frame >> job.frames >>
        job.tile_side >> job.threads >> job.in_slices >> job.count >> tiles;
    job.tiles.resize(tiles);
    for (int& tile : job.tiles) in >> tile;
    in >> files;
    job.files.resize(files);
    for (auto& [name, content] : job.files) {
        std::size_t name_size = 0, size = 0;
        in >> name_size >> size;
        in.get();
        name.resize(name_size);
        content.resize(size);
        in.read(name.data(), static_cast<std::streamsize>(name_size));
        in.read(content.data(), static_cast<std::streamsize>(size));
    }
    return job;
}

// The number of the tile at `index`, 0 ... count - 1, among those that are to be drawn.
inline int tile_number(const Job& job, int index) {
    return job.tiles.empty() ? index : job.tiles[static_cast<std::size_t>(index)];
}

// The scene file, and the files that reading the scene takes, such as meshes and their materials.
// Every rank keeps them in its memory while it reads the scene, so that together they may have at
// most `most` bytes.
inline std::vector<NamedFile> files_of(const fs::path& scene,
                                       std::size_t most = std::size_t{1} << 29) {
    const std::string text = app::read_input_file(scene, scene.string(), app::max_json_bytes);
    const fs::path folder = scene.has_parent_path() ? scene.parent_path() : fs::path{"."};
    std::vector<NamedFile> files{{"", text}};
    std::size_t bytes = text.size();
    full_renderer::parse_scene(
        text, scene.string(),
        [&](const app::Value& where, const std::string& name, const std::string& kind,
            std::size_t most_bytes) {
            for (const NamedFile& known : files)
                if (known.name == name) return known.bytes;
            files.push_back({name, effects::read_neighbor(where, name, folder, kind, most_bytes)});
            bytes += files.back().bytes.size();
            if (bytes > most)
                throw app::UsageError(
                    scene.string() + " and the files that it names are larger than " +
                    std::to_string(most >> 20) + " MiB together, the most that ranks send");
            return files.back().bytes;
        });
    return files;
}

// Turns the scene's view to the frame that a job asks for.
inline void turn_to_frame(rt::SceneDescription& scene, const Job& job) {
    rt::View& view = scene.camera.view;
    if (job.frames > 1) view = rt::turned_view(view, job.frame, job.frames);
}

// The scene of a job, on a rank that has nothing but the job's files. Nothing is written to a disk.
inline rt::MeshedDescription scene_of(const Job& job) {
    rt::MeshedDescription scene;
    const auto find = [&](const app::Value& where, const std::string& name, const std::string&,
                          std::size_t) {
        for (const NamedFile& named : job.files)
            if (named.name == name) return named.bytes;
        where.fail("names a file that rank 0 has not sent");
    };
    if (job.files.empty())
        scene = {effects::final_scene(), {}};
    else
        scene = full_renderer::parse_scene(job.files[0].bytes, "the scene", find);
    scene.settings = job.settings;
    turn_to_frame(scene, job);
    return scene;
}

}  // namespace cluster
