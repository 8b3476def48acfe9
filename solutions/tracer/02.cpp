#include <cmath>
#include <iostream>
#include <rt/dot.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/length.hpp>
#include <rt/make_camera.hpp>
#include <rt/primary_ray.hpp>
#include <rt/vec3.hpp>
#include <string>

using namespace rt;

struct Ball {
    Vec3 center;
    double radius;
};

// The t at which the ray meets the ball, at origin + t * direction; -1 if it misses.
double hit(Ball ball, Ray ray) {
    Vec3 offset = ray.origin - ball.center;
    double a = dot(ray.direction, ray.direction);
    double b = 2 * dot(offset, ray.direction);
    double c = dot(offset, offset) - ball.radius * ball.radius;
    double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return -1;
    double front = (-b - std::sqrt(discriminant)) / (2 * a);
    double back = (-b + std::sqrt(discriminant)) / (2 * a);
    if (front > 0.001) return front;
    if (back > 0.001) return back;
    return -1;
}

int main(int count, char** words) {
    Ball balls[] = {{{0, 0, -4}, 1}, {{0, -1001, -4}, 1000}};
    Vec3 eye = {3, 1, 0};
    if (count == 4) eye = {std::stod(words[1]), std::stod(words[2]), std::stod(words[3])};
    Vec3 to_light = normalize(Vec3{-2, 2, 1});
    int width = 320;
    int height = 180;
    Camera camera = make_camera({eye, {0, 0, -4}, {0, 1, 0}, radians(50)}, width, height);
    std::cout << "P3\n" << width << " " << height << "\n255\n";
    for_each_pixel({0, 0, width, height}, [&](int column, int row) {
        Ray ray = primary_ray(camera, column, row, {0.5, 0.5});
        double up = ray.direction.y;
        Vec3 color = {0.6 - 0.4 * up, 0.5 - 0.15 * up, 0.55 + 0.1 * up};
        double nearest = -1;
        for (Ball ball : balls) {
            double t = hit(ball, ray);
            if (t < 0 || (nearest > 0 && t > nearest)) continue;
            nearest = t;
            Vec3 point = ray.at(t);
            Vec3 normal = normalize(point - ball.center);
            color = 0.5 * (normal + Vec3{1, 1, 1});
            bool shadow = false;
            for (Ball other : balls)
                if (hit(other, {point, to_light}) > 0) shadow = true;
            if (shadow) color = 0.4 * color;
        }
        std::cout << int(255 * color.x) << " " << int(255 * color.y) << " " << int(255 * color.z)
                  << "\n";
    });
}
