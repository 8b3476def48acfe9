// Exercise 00.1. Your first ray tracer: one program in this one file. Empty the file and type the
// program here, in the five steps of docs/00-toolchain.md. Each step draws a picture.

int main() {
#if 0  // the compiler skips the lines up to #endif; they tell the check that you have not begun
    rt::todo("00.1");
#endif
}
