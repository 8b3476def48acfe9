#pragma once
#include <cmath>
#include <rt/renderer.hpp>
#include <vector>

namespace rt {

// Where a path starts in the picture: at a point in a cell of a pixel (04.5).
struct SamplePoint {
    Real column, row;
    Vec2 first;  // the cell's first corner, in cells
    Vec2 place;  // the point in the cell, as a point of the unit square
    Vec2 end;    // the largest offset in the cell; infinite if the cell is the whole pixel
};

// The samples of JitteredSamples (given), handed over one by one, so that their paths can be
// followed later.
class JitteredPoints {
  public:
    using Random = Rng;

    explicit JitteredPoints(const JitteredSamples& samples) : samples_{samples} {
        while ((cells_ + 1) * (cells_ + 1) <= samples.count) ++cells_;
        for (int cell = 0; cell < cells_; ++cell)
            ends_.push_back(
                std::nextafter(static_cast<Real>(cell + 1) / static_cast<Real>(cells_), Real(0)));
    }

    int count() const { return samples_.count; }
    int cells() const { return cells_; }  // in each row of a pixel

    // Calls add() for each sample of a pixel, in order, with the arguments that make the sample's
    // Random. add() returns references to the sample's point and its Random.
    template <class Add>
    void each(int x, int y, const Add& add) const {
        const std::uint64_t seed = samples_.seed;
        Rng places = pixel_rng(seed, x, y);
        int sample = 0;
        const auto add_next = [&](Vec2 first, Vec2 end) {
            add(sample_rng(seed, x, y, sample++)).point = {
                static_cast<Real>(x), static_cast<Real>(y), first, random_place(places), end};
        };
        for (int down = 0; down < cells_; ++down)
            for (int right = 0; right < cells_; ++right)
                add_next({static_cast<Real>(right), static_cast<Real>(down)},
                         {end_of(right), end_of(down)});
        while (sample < samples_.count) add_next({}, {infinity, infinity});
    }

  private:
    Real end_of(int cell) const { return ends_[static_cast<std::size_t>(cell)]; }

    JitteredSamples samples_;
    int cells_ = 1;
    std::vector<Real> ends_;  // the largest offset in each cell
};

}  // namespace rt
