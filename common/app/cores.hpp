#pragma once
#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <thread>

namespace app {

// The number of physical cores, at least 1. Two threads on one core share its arithmetic units, so
// the number of logical cores would promise too much. If the system does not tell, the result is
// the number of threads that can run at once.
inline int physical_cores() {
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::set<std::string> cores;
    for (int i = 0;; ++i) {
        std::ifstream in{"/sys/devices/system/cpu/cpu" + std::to_string(i) +
                         "/topology/thread_siblings_list"};
        std::string siblings;
        if (!std::getline(in, siblings)) break;
        cores.insert(siblings);
    }
    return cores.empty() ? threads : std::min(threads, static_cast<int>(cores.size()));
}

}  // namespace app
