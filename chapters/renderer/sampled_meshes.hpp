#pragma once
// What draws scenes with meshes by chapter 11's ways. There is only one renderer for such scenes,
// with all effects, because more renderers would take longer to compile.

#include <memory>
#include <rt/draw_by_tiles.hpp>
#include <rt/draw_passes.hpp>
#include <rt/mesh_scene.hpp>
#include <rt/tent_filter.hpp>

namespace full_renderer {

// Passes of Sobol's points, or of jittered samples.
rt::DrawPass make_meshed_passes(const rt::MeshedDescription& scene, int width, int height,
                                const rt::Quality& quality, bool sobol);
// Draws each tile, filtered with a tent.
rt::DrawTile make_meshed_tent(const rt::MeshedDescription& scene, int width, int height,
                              const rt::Quality& quality);

// Passes that keep their renderer alive.
template <class AnyRenderer>
rt::DrawPass kept_passes(std::shared_ptr<const AnyRenderer> renderer, int count, bool sobol) {
    return [renderer,
            draw = sobol ? sobol_passes(*renderer, count) : jittered_passes(*renderer, count)](
               const rt::Tile& tile, const rt::Pass& pass, rt::Image& image, std::uint64_t& rays) {
        draw(tile, pass, image, rays);
    };
}

// Draws tiles, filtered with a tent, by a renderer that it keeps alive.
template <class AnyRenderer>
rt::DrawTile kept_tent(std::shared_ptr<const AnyRenderer> renderer, const rt::Quality& quality) {
    return [renderer, samples = rt::SobolSamples{quality.seed, quality.samples_per_pixel}](
               const rt::Tile& tile, rt::Image& image, std::uint64_t& rays) {
        draw_with_tent(*renderer, samples, tile, image, rays);
        return pixel_count(tile);
    };
}

}  // namespace full_renderer
