// The only file that compiles the implementation of the image library. It includes only the file
// formats that the course reads.
#include <cstdlib>

// A small file can claim to unpack to any size. The limit leaves room for 2^23 pixels of 16 bytes.
constexpr std::size_t most_bytes = std::size_t{1} << 27;
#define STBI_MALLOC(size) ((size) <= most_bytes ? std::malloc(size) : nullptr)
#define STBI_REALLOC(old, size) ((size) <= most_bytes ? std::realloc(old, size) : nullptr)
#define STBI_FREE(old) std::free(old)

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_PNM
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
