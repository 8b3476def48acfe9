#pragma once
// A list with numbers before and after it that do not belong to it: if something is written there,
// or read from there, it shows.

#include <algorithm>
#include <span>
#include <vector>

namespace checkpoint {

template <class Number>
class Fenced {
  public:
    Fenced(std::size_t size, Number inside, Number fence, std::size_t width = 67)
        : all_(size + 2 * width, fence), fence_{fence}, width_{width} {
        std::fill_n(data(), size, inside);
    }
    Fenced(const std::vector<Number>& inside, Number fence) : Fenced(inside.size(), fence, fence) {
        std::copy(inside.begin(), inside.end(), data());
    }
    Number* data() { return all_.data() + width_; }
    std::size_t size() const { return all_.size() - 2 * width_; }
    std::span<Number> span() { return {data(), size()}; }
    // Whether nothing was written before or after the list.
    bool stands() const {
        const auto is_fence = [this](Number number) { return number == fence_; };
        const auto width = static_cast<std::ptrdiff_t>(width_);
        return std::all_of(all_.begin(), all_.begin() + width, is_fence) &&
               std::all_of(all_.end() - width, all_.end(), is_fence);
    }

  private:
    std::vector<Number> all_;
    Number fence_;
    std::size_t width_;
};

}  // namespace checkpoint
