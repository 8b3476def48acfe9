#include <app/run.hpp>

void (*const app::program_study)(study::Report&) = nullptr;
