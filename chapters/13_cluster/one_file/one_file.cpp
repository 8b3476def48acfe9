// All ranks write one picture into one file (MPI-IO): each rank writes its own tiles, so rank 0
// need not collect them. The file is the same as if rank 0 wrote it alone.
//
//     mpirun -n 4 build/bin/cluster_one_file WIDTH HEIGHT SAMPLES FILE.ppm

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <rt/image_file.hpp>
#include <rt/ranks.hpp>

#include "final_scene.hpp"
#include "group.hpp"
#include "tile_drawer.hpp"

namespace {

using namespace rt;

// The bytes of a tile's pixels in a .ppm file, without the file's header.
std::string bytes_of(const Tile& tile, const PixelColor& color) {
    std::uint64_t rays = 0;
    const std::string file =
        encode_ppm(make_image(tile.right - tile.left, tile.bottom - tile.top, [&](int x, int y) {
            return color(tile.left + x, tile.top + y, rays);
        }));
    return file.substr(file.size() - 3 * static_cast<std::size_t>(pixel_count(tile)));
}

void write_at(MPI_File file, std::int64_t place, const char* bytes, int count) {
    MPI_File_write_at(file, place, bytes, count, MPI_BYTE, MPI_STATUS_IGNORE);
}

}  // namespace

int main(int argc, char** argv) {
    const cluster::Membership membership{argc, argv};
    if (argc != 5) return app::bad_input;
    MeshedDescription scene{effects::final_scene(), {}};
    scene.settings.width = std::atoi(argv[1]);
    scene.settings.height = std::atoi(argv[2]);
    scene.settings.samples_per_pixel = std::atoi(argv[3]);
    if (std::min({scene.settings.width, scene.settings.height, scene.settings.samples_per_pixel}) <
        1)
        return app::bad_input;
    const TileGrid grid{scene.settings.width, scene.settings.height, 8};
    const std::string header =
        "P6\n" + std::to_string(grid.width) + ' ' + std::to_string(grid.height) + "\n255\n";

    MPI_File file{};
    MPI_File_set_errhandler(MPI_FILE_NULL, MPI_ERRORS_ARE_FATAL);  // for all files opened later
    MPI_File_open(MPI_COMM_WORLD, argv[4], MPI_MODE_CREATE | MPI_MODE_WRONLY, MPI_INFO_NULL, &file);
    MPI_File_set_size(file, 0);  // removes the contents of an older file
    const int rank = rank_of(MPI_COMM_WORLD), count = rank_count(MPI_COMM_WORLD);
    if (rank == 0) write_at(file, 0, header.data(), static_cast<int>(header.size()));
    const PixelColor color = cluster::colors_of(scene);
    for (int index = rank; index < tile_count(grid); index += count) {
        const Tile tile = tile_at(grid, index);
        const std::string bytes = bytes_of(tile, color);
        const int row_bytes = 3 * (tile.right - tile.left);
        for (int y = tile.top; y < tile.bottom; ++y)
            write_at(file,
                     static_cast<std::int64_t>(header.size()) +
                         3 * (std::int64_t{y} * grid.width + tile.left),
                     &bytes[static_cast<std::size_t>((y - tile.top) * row_bytes)], row_bytes);
    }
    MPI_File_close(&file);
}
