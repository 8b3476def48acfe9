#include <app/errors.hpp>
#include <companion/system/files.hpp>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace companion {

std::string read_file(const std::filesystem::path& path) {
    std::ifstream in{path, std::ios::binary};
    std::string bytes{std::istreambuf_iterator<char>{in}, {}};
    if (!in.is_open() || in.bad()) throw app::Failure("cannot read " + path.string());
    return bytes;
}

std::string hash_of(const std::string& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

}  // namespace companion
