#pragma once
#include <rt/todo.hpp>
#include <stdexcept>
#include <string>

namespace checkpoint {

// What a call throws, in words, where std::domain_error is right.
template <class Call>
std::string refusal(Call call) {
    try {
        call();
    } catch (const std::domain_error&) {
        return "std::domain_error";
    } catch (const rt::NotImplemented&) {
        throw;
    } catch (const std::exception& other) {
        return "another exception: " + std::string(other.what());
    }
    return "nothing was thrown";
}

}  // namespace checkpoint
