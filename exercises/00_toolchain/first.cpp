// Exercise 00.1. Your first ray tracer: one program in this one file. Empty the file and type the
// program here, in the five steps of docs/00-toolchain.md. Each step draws a picture.
// Star: rays go through the middle of their pixels, so that the disk covers exactly the pixels
// whose middle lies in it; light and shadow have their edges in the right place, and no specks.

int main() {
#if 0  // the compiler skips the lines up to #endif; they tell the check that you have not begun
    rt::todo("00.1");
#endif
}
