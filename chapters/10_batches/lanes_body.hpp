#pragma once
#include <memory>
#include <rt/load_eight.hpp>

#include "lanes.hpp"
#include "pictures.hpp"

namespace batches {

inline Width make_width() {
    struct Ways {
        StudyScene scene{100'000};
        BatchRenderer<scene_effects> renderer{scene.ready, study_quality};
        Image image = Canvas<Color>{study_width, study_height};
    };
    const auto ways = std::make_shared<Ways>();
    return {pack_size, [ways] { return draw_singly(ways->scene, ways->image); },
            [ways] { return draw_in_batches(ways->renderer, ways->image); }};
}

}  // namespace batches
