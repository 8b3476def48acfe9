#pragma once
// An answer hands its functions to the checkpoint in answer.cpp, from a namespace that the library
// shows: `namespace answer EXPORTED { ... }`. All its other functions stay inside, above all those
// that the checkpoint has as well, in the solution's version.

#define EXPORTED __attribute__((visibility("default")))
