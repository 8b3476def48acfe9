#include <answer.hpp>
#include <rt/orthonormal_basis.hpp>

namespace answer EXPORTED {

rt::Basis orthonormal_basis(const rt::Vec3& w) {
    return rt::orthonormal_basis(w);
}

}  // namespace EXPORTED
