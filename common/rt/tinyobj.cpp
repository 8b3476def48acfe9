// The only file that compiles the implementation of the library that reads material files.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
