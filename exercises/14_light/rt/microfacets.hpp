#pragma once
#include <algorithm>
#include <cmath>
#include <rt/color.hpp>
#include <rt/length.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Facets: the tiny mirrors that a rough surface is made of. All directions have length 1 and are
// given in the surface's own coordinates, with its normal along z. `out` leads to the eye, and `in`
// to the light. The roughness alpha, from 0.0001 to 1, is the slope of a typical facet.

// Exercise 14.4. The area of the facets that face in this direction, per solid angle and per area
// of the surface: GGX. It is 0 for a direction that is not above the surface.
// Star: accurate to 30 epsilon, even if alpha is small and the facet almost level.
inline Real facet_density(Vec3 facet, Real alpha) {
    return rt::todo("14.4", facet, alpha);
}

// Exercise 14.4. The normal of a facet that is seen from `out`: the larger a facet appears from
// there, the more likely it is drawn. `place` is a sample point of the unit square, 0 <= x, y < 1.
// The result has length 1; it is above the surface, and `out` is on its upper side.
// Star: so it is for an `out` that grazes the surface, too, with out.z = 0.
// Source: Dupuy and Benyoub, "Sampling visible GGX normals with spherical caps", 2023.
inline Vec3 visible_facet(Vec3 out, Real alpha, Vec2 place) {
    return rt::todo("14.4", out, alpha, place);
}

// Exercise 14.4. Of the facets that are seen from `out`, the share that `in`, above the surface,
// reaches as well: G2 / G1 by Smith's masking, for facets whose height counts for both directions.
// Star: accurate to 30 epsilon at grazing angles, too, where out.z may be 0.
inline Real unshadowed(Vec3 out, Vec3 in, Real alpha) {
    return rt::todo("14.4", out, in, alpha);
}

// Exercise 14.4. The probability density of `in`, per solid angle, when light leaves along `out` by
// a facet from visible_facet. It is 0 below the surface.
// Star: finite and above 0 for each `in` that visible_facet leads to, even if out.z is 0.
inline Real reflection_density(Vec3 out, Vec3 in, Real alpha) {
    return rt::todo("14.4", out, in, alpha);
}

// Exercise 14.4. The fraction of light that metal reflects, by Schlick, for each channel: `head_on`
// at a cosine of 1, all of it at a cosine of 0. The cosine, from 0 to 1, is that of the angle
// between a facet's normal and `out`.
inline Color metal_reflectance(Color head_on, Real cosine) {
    return rt::todo("14.4", head_on, cosine);
}

// Exercise 14.4. A factor, 1 or more, for the light that comes back only after several bounces
// among the facets. `kept`, in (0, 1], is the share of the light that a single bounce keeps on a
// white metal; if it is 1, the factor is 1. Without the star, the factor is always 1.
// Star: together with `kept`, a white metal loses nothing, and a black one gains nothing.
// Source: Turquin, "Practical multiple scattering compensation for microfacet models", 2019.
inline Color compensation(Color head_on, Real kept) {
    return rt::todo("14.4", head_on, kept);
}

}  // namespace rt
