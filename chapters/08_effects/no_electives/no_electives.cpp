// In place of what chapters 10, 11 and 12 add to this program, and what takes most of the time to
// compile: it says which program has it. See CMakeLists.txt.

#include <app/errors.hpp>
#include <string>

#include "tile_renderer.hpp"

namespace effects {
namespace {

[[noreturn]] void leave_out(const std::string& what) {
    throw app::UsageError(what + " is not in this program; 08_effects_mine_full has it");
}

}  // namespace

TileRenderer make_batched(const rt::SceneDescription&, int, int, const rt::Quality&) {
    leave_out("--batches");
}

TileRenderer make_sobol(const rt::SceneDescription&, int, int, const rt::Quality&, bool) {
    leave_out("--sampler sobol");
}

TileRenderer make_tent(const rt::SceneDescription&, int, int, const rt::Quality&, bool) {
    leave_out("--filter tent");
}

TileRenderer make_meshed(const rt::SceneDescription&, int, int, const rt::Quality&) {
    leave_out("drawing meshes");
}

app::Picture show_meshed(rt::SceneDescription, const app::Settings&, app::Progress&) {
    leave_out("drawing meshes");
}

rt::Mesh read_mesh(const std::string&, std::optional<bool>) {
    leave_out("reading meshes");
}

app::Picture refine(const rt::SceneDescription&, const app::Settings&,
                    const std::function<void(const Choice&)>&, app::Progress&) {
    leave_out("refining a picture");
}

}  // namespace effects
