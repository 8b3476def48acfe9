#pragma once
// An answer hands its functions to the checkpoint in answer.cpp. Here a library shows all its
// functions, and its own calls stay inside anyway.

#define EXPORTED
