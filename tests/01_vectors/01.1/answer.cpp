#include <answer.hpp>
#include <rt/vec3.hpp>

namespace answer EXPORTED {

rt::Vec3 operator+(const rt::Vec3& a, const rt::Vec3& b) {
    return rt::operator+(a, b);
}

rt::Vec3 operator-(const rt::Vec3& a, const rt::Vec3& b) {
    return rt::operator-(a, b);
}

rt::Vec3 operator*(const rt::Vec3& v, const rt::Real s) {
    return rt::operator*(v, s);
}

rt::Vec3 operator/(const rt::Vec3& v, const rt::Real s) {
    return rt::operator/(v, s);
}

}  // namespace EXPORTED
