#pragma once
// What rank 0 sends to the other ranks: the scene, and which part of the picture to draw.

#include <stdlib.h>

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/json.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <rt/scene.hpp>
#include <rt/turned_view.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "final_scene.hpp"
#include "open_meshed.hpp"

namespace cluster {

namespace fs = std::filesystem;

// A file's name within the scene's folder, and its bytes.
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
    std::vector<int> tiles;        // the tiles to draw
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
          std::uint64_t{job.in_slices}, std::uint64_t{job.tiles.size()}})
        out << number << ' ';
    for (const int tile : job.tiles) out << tile << ' ';
    out << job.files.size() << '\n';
    for (const auto& [name, bytes] : job.files)
        out << name.size() << ' ' << bytes.size() << '\n' << name << bytes;
    return out.str();
}

inline Job unpacked(const std::string& bytes) {
    std::istringstream in{bytes};
    Job job;
    auto& [width, height, samples, depth, seed] = job.settings;
    std::size_t tiles = 0, files = 0;
    in >> job.is_none >> width >> height >> samples >> depth >> seed >> job.frame >> job.frames >>
        job.tile_side >> job.threads >> job.in_slices >> tiles;
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

// Adds the names of all files that a scene file names: the values of all keys "file".
inline void add_names(const nlohmann::json& value, std::vector<std::string>& names) {
    if (value.is_object())
        for (const auto& [key, member] : value.items())
            if (key == "file" && member.is_string()) names.push_back(member.get<std::string>());
    if (value.is_structured())
        for (const auto& member : value) add_names(member, names);
}

// The scene file, which must be readable, and the files that it names.
inline std::vector<NamedFile> files_of(const fs::path& scene) {
    constexpr std::size_t most = std::size_t{1} << 28;
    std::vector<NamedFile> files{
        {"scene.json", app::read_input_file(scene, scene.string(), app::max_json_bytes)}};
    std::vector<std::string> names;
    add_names(app::parse_json(files[0].bytes, scene.string()), names);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const std::string& name : names)
        files.push_back({name, app::read_input_file(scene.parent_path() / name, name, most)});
    return files;
}

// Turns the scene's view to the frame that a job asks for.
inline void turn_to_frame(rt::SceneDescription& scene, const Job& job) {
    rt::View& view = scene.camera.view;
    if (job.frames > 1) view = rt::turned_view(view, job.frame, job.frames);
}

// The scene of a job, on a rank that has nothing but the job's files.
inline rt::MeshedDescription scene_of(const Job& job) {
    rt::MeshedDescription scene;
    if (job.files.empty()) {
        scene = {effects::final_scene(), {}};
    } else {
        std::string name = fs::temp_directory_path() / "scene.XXXXXX";
        if (!::mkdtemp(name.data()))
            throw app::Failure("a rank cannot make a folder in " +
                               fs::temp_directory_path().string() + "; free some space there");
        const fs::path folder = name;
        for (const auto& [file, bytes] : job.files) {
            fs::create_directories((folder / file).parent_path());
            std::ofstream{folder / file, std::ios::binary} << bytes;
        }
        scene = full_renderer::read_scene(folder / "scene.json");
        fs::remove_all(folder);
    }
    scene.settings = job.settings;
    turn_to_frame(scene, job);
    return scene;
}

}  // namespace cluster
