#include <answer.hpp>
#include <functional>
#include <rt/run_workers.hpp>

namespace answer EXPORTED {

void run_workers(int workers, const std::function<void(int)>& work) {
    rt::run_workers(workers, work);
}

}  // namespace EXPORTED
