#pragma once
// What for_each_pixel is written over, as types that both sides know.

#include <functional>
#include <memory>
#include <utility>

namespace answer {

using Visit = std::function<void(int column, int row)>;

// A visit that cannot be copied, and whose call is not const. Once moved from, it cannot be called.
class OneVisit {
  public:
    explicit OneVisit(Visit visit) : visit_{std::make_unique<Visit>(std::move(visit))} {}
    void operator()(int column, int row) { (*visit_)(column, row); }

  private:
    std::unique_ptr<Visit> visit_;
};

}  // namespace answer
