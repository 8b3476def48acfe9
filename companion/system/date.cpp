#include <companion/system/date.hpp>

namespace companion {

std::string date_of(std::time_t time) {
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&time));
    return text;
}

}  // namespace companion
