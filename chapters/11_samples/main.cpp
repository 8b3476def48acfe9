// Chapter 11.

int main() {}
