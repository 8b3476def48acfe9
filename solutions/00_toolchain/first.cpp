#include <cmath>
#include <iostream>

struct Vec {
    double x, y, z;
};

Vec operator+(Vec a, Vec b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator-(Vec a, Vec b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec operator*(double s, Vec a) {
    return {s * a.x, s * a.y, s * a.z};
}
double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct Sphere {
    Vec center;
    double radius;
};

// The t at which origin + t * direction lies on the sphere, or -1 if the ray misses it.
double hit(Sphere sphere, Vec origin, Vec direction) {
    Vec offset = origin - sphere.center;
    double a = dot(direction, direction);
    double b = 2 * dot(offset, direction);
    double c = dot(offset, offset) - sphere.radius * sphere.radius;
    double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return -1;
    double front = (-b - std::sqrt(discriminant)) / (2 * a);
    double back = (-b + std::sqrt(discriminant)) / (2 * a);
    if (front > 0.001) return front;
    if (back > 0.001) return back;
    return -1;
}

int main() {
    Sphere spheres[] = {{{0, 0, -4}, 1}, {{0, -1001, -4}, 1000}};
    Vec eye = {0, 0, 0};
    Vec to_light = {-2, 2, 1};
    int width = 320;
    int height = 180;
    std::cout << "P3\n" << width << " " << height << "\n255\n";
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            double up = 1 - 2 * (row + 0.5) / height;
            double right = (2 * (column + 0.5) - width) / height;
            Vec direction = {right, up, -2};
            Vec color = {0.6 - 0.4 * up, 0.5 - 0.15 * up, 0.55 + 0.1 * up};
            double nearest = -1;
            for (Sphere sphere : spheres) {
                double t = hit(sphere, eye, direction);
                if (t < 0 || (nearest > 0 && t > nearest)) continue;
                nearest = t;
                Vec point = eye + t * direction;
                Vec normal = (1 / sphere.radius) * (point - sphere.center);
                color = 0.5 * (normal + Vec{1, 1, 1});
                bool shadow = false;
                for (Sphere other : spheres)
                    if (hit(other, point, to_light) > 0) shadow = true;
                if (shadow) color = 0.4 * color;
            }
            std::cout << int(255 * color.x) << " " << int(255 * color.y) << " "
                      << int(255 * color.z) << "\n";
        }
    }
}
