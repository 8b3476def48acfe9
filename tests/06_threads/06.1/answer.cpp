#include <answer.hpp>
#include <rt/slice_rows.hpp>

namespace answer EXPORTED {

rt::Rows slice_rows(int height, int workers, int worker) {
    return rt::slice_rows(height, workers, worker);
}

}  // namespace EXPORTED
