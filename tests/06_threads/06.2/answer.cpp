#include <answer.hpp>
#include <rt/render_slices.hpp>
#include <rt/run_workers.hpp>
#include <rt/slice_rows.hpp>

namespace answer EXPORTED {

void run_workers(int workers, const std::function<void(int)>& work) {
    rt::run_workers(workers, work);
}

void render_slices(const rt::TileGrid& grid, int workers, const rt::TileWork& work) {
    rt::render_slices(grid, workers, work);
}

rt::Rows slice_rows(int height, int workers, int worker) {
    return rt::slice_rows(height, workers, worker);
}

}  // namespace EXPORTED
