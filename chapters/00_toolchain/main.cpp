// Chapter 00: the first picture. On a gradient it shows what a program's memory consists of (code,
// static data, heap and stack, with arrows for pointers), and what it costs to jump around in
// memory. The program prints the real addresses and times of this machine.

#include <app/run.hpp>
#include <rt/gradient.hpp>
#include <string>

#include "address_map.hpp"
#include "chain_panel.hpp"
#include "facts.hpp"
#include "memory_panel.hpp"
#include "time_panels.hpp"

namespace {

using namespace toolchain;

// A static variable: it exists before main() begins, and until the program ends.
const Corners dusk{from_hex(0x17153b), from_hex(0x5b2a86), from_hex(0xc8496b), from_hex(0xffb35c)};

// Fills the canvas with y upward, as in school, then flips it, because row 0 of a picture is the
// top row. The canvas is moved through flipped() and out of here: no pixel is copied.
Canvas<Color> paint_dusk(int width, int height) {
    Canvas<Color> canvas{width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Real across = (static_cast<Real>(x) + Real(0.5)) / static_cast<Real>(width);
            const Real up = (static_cast<Real>(y) + Real(0.5)) / static_cast<Real>(height);
            canvas.at(x, y) = gradient(dusk, across, 1 - up);
        }
    return flipped(std::move(canvas));
}

app::Picture render(const app::Settings& settings, app::Progress&) {
    const bool by_machine = settings.choice("numbers") == "machine";
    const Canvas<Color> canvas = paint_dusk(64, 36);
    std::unique_ptr<RangeNode> root = make_tree<RangeNode>(0, 8);
    Color (*const paint)(const Corners&, Real, Real) = gradient;

    const void* const code = reinterpret_cast<const void*>(paint);
    const void* const left = root && root->left ? root->left.get() : nullptr;
    const void* const right = root && root->right ? root->right.get() : nullptr;
    std::vector<Thing> things{
        {"stack", &canvas, "canvas: width, height, pixels", canvas.begin()},
        {"stack", &root, "root, a unique_ptr", root.get()},
        {"stack", &paint, "paint, a pointer to a function", code},
        {"heap", canvas.begin(), std::to_string(canvas.size()) + " pixels", nullptr},
        {"heap", root.get(), "node 0 ... 7", nullptr},
        {"heap", root ? &root->left : nullptr, "  its left", left},
        {"heap", root ? &root->right : nullptr, "  its right", right},
        {"heap", left, "node 0 ... 3", nullptr},
        {"heap", right, "node 4 ... 7", nullptr},
        {"static", &dusk, "dusk, four colors", nullptr},
        {"code", code, "gradient", nullptr},
    };
    const std::string map = draw_map(things);

    Image image = paint_dusk(settings.width, settings.height);
    std::vector<Steps> steps = model_steps();
    Objects objects;
    std::vector<std::string> addresses;
    if (by_machine) {
        steps = measure_steps();
        objects = measure_objects<64>();
        for (const void* const address :
             {static_cast<const void*>(&canvas), static_cast<const void*>(&root),
              static_cast<const void*>(&paint), static_cast<const void*>(canvas.begin()),
              static_cast<const void*>(&dusk), code}) {
            std::string text = hex(address);
            std::transform(text.begin(), text.end(), text.begin(), [](unsigned char letter) {
                return static_cast<char>(std::toupper(letter));
            });
            addresses.push_back(text);
        }
    }
    Figure figure{image, 960, 540};
    draw_memory(figure, {24, 24, 440, 492}, canvas, root.get(), addresses);
    draw_chain(figure, {484, 24, 452, 232});
    draw_steps(figure, {484, 276, 268, 240}, steps, by_machine);
    draw_objects(figure, {772, 276, 164, 240}, objects, by_machine);
    return {std::move(image), 0, [map, said = facts(std::move(root), canvas)] {
                return "Where things are in this run:\n" + map + '\n' + said + '\n' +
                       objects_table({measure_objects<16>(), measure_objects<256>(),
                                      measure_objects<4096>()}) +
                       '\n' + steps_table(measure_steps());
            }};
}

}  // namespace

int main(int argc, char** argv) {
    return app::run(
        argc, argv,
        {.name = "00_toolchain",
         .about = "A gradient, and on it where a program's things live in memory.",
         .defaults = {.width = 960, .height = 540, .seed = {}},
         .render = render,
         .study = app::program_study,
         .choices = {{"numbers",
                      "The times and addresses in the picture: a model's (the same on every "
                      "machine), or this machine's",
                      {"model", "machine"}}}});
}
