// image_compare A B: exit 0 when two image files show the same picture, that is, when at most
// one pixel in a thousand differs by more than one step of 255 in any channel. Otherwise it says
// how they differ.
#include <stb_image.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc != 3) return std::fprintf(stderr, "usage: image_compare A B\n"), 2;
    stbi_uc* pixels[2];
    int width[2], height[2], channels;
    for (int i : {0, 1}) {
        pixels[i] = stbi_load(argv[i + 1], &width[i], &height[i], &channels, 3);
        if (!pixels[i]) return std::fprintf(stderr, "%s cannot be read\n", argv[i + 1]), 2;
    }
    if (width[0] != width[1] || height[0] != height[1])
        return std::fprintf(stderr, "%dx%d against %dx%d pixels\n", width[0], height[0], width[1],
                            height[1]),
               1;
    long different = 0;
    int largest = 0;
    const long count = static_cast<long>(width[0]) * height[0];
    for (long i = 0; i < count; ++i) {
        int difference = 0;
        for (long c = 3 * i; c < 3 * i + 3; ++c)
            difference = std::max(difference, std::abs(pixels[0][c] - pixels[1][c]));
        largest = std::max(largest, difference);
        different += difference > 1;
    }
    for (stbi_uc* const image : pixels) stbi_image_free(image);
    std::printf("%ld of %ld pixels differ by more than 1, the largest difference is %d\n",
                different, count, largest);
    return 1000 * different > count;
}
