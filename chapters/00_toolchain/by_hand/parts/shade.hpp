// What the function looks like from outside: its declaration.
int shade(int x, int y, int channel);
