// The one place where the reader of image files is compiled.
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
