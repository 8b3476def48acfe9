#include <answer.hpp>
#include <rt/transform.hpp>

namespace answer EXPORTED {

rt::Vec3 transform_point(const rt::Mat4& m, const rt::Vec3& p) {
    return rt::transform_point(m, p);
}

rt::Vec3 transform_vector(const rt::Mat4& m, const rt::Vec3& v) {
    return rt::transform_vector(m, v);
}

rt::Vec3 transform_normal(const rt::Mat4& inverse, const rt::Vec3& n) {
    return rt::transform_normal(inverse, n);
}

rt::Mat4 multiply(const rt::Mat4& a, const rt::Mat4& b) {
    return rt::multiply(a, b);
}

}  // namespace EXPORTED
