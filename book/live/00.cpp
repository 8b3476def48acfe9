// The live figures of chapter 00.
#include <array>
#include <rt/canvas.hpp>

#include "controls.hpp"
#include "live.hpp"

namespace live {
namespace {

// ---- Stack and heap, line by line ----

// The heap of the figure: room for a few blocks of pixels, so that addresses are the same each
// time.
struct Heap {
    static constexpr std::size_t most = 6;
    struct alignas(64) Room {
        std::array<char, 64> bytes;
    };
    std::array<Room, most> rooms;
    std::array<std::size_t, most> used{};  // bytes
    int allocated = 0;                     // blocks, in all

    void* take(std::size_t bytes) {
        for (std::size_t i = 0; i < most; ++i)
            if (used[i] == 0 && bytes <= sizeof(Room)) {
                used[i] = bytes;
                ++allocated;
                return &rooms[i];
            }
        std::abort();
    }
    void give_back(void* block) {
        for (std::size_t i = 0; i < most; ++i)
            if (block == &rooms[i]) used[i] = 0;
    }
};
Heap heap;

struct Pixel {
    int value = 0;

    static void* operator new[](std::size_t bytes) { return heap.take(bytes); }
    static void operator delete[](void* block) noexcept { heap.give_back(block); }
};
using Canvas = rt::Canvas<Pixel>;

struct Variable {
    std::string name, value;
    const void* address;
    const void* target = nullptr;  // what it points to, if anything
};
struct Call {
    std::string function;
    std::vector<Variable> variables;
};
struct Block {
    const void* address;
    std::vector<int> pixels;  // none: free
};

// The memory after a line has run.
struct State {
    int line;
    std::string_view what;
    std::vector<Call> stack;
    std::vector<Block> blocks;
    int allocated;
    std::vector<std::string> printed;
};

std::string hex(const void* address) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (auto bits = reinterpret_cast<std::uintptr_t>(address); bits != 0; bits /= 16)
        text.insert(text.begin(), digits[bits % 16]);
    return "0x" + text;
}

struct Program {
    std::vector<std::string_view> lines;
    std::vector<State> states;
    std::vector<std::string> printed;

    void ran(int line, std::string_view what, std::vector<Call> stack) {
        std::vector<Block> blocks;
        for (std::size_t i = 0; i < Heap::most; ++i) {
            const auto* pixels = reinterpret_cast<const Pixel*>(&heap.rooms[i]);
            Block block{pixels, {}};
            for (std::size_t k = 0; k < heap.used[i] / sizeof(Pixel); ++k)
                block.pixels.push_back(pixels[k].value);
            blocks.push_back(block);
        }
        states.push_back({line, what, std::move(stack), blocks, heap.allocated, printed});
    }
};

Variable variable(std::string_view name, const Canvas& canvas) {
    return {std::string{name},
            std::to_string(canvas.width()) + ", " + std::to_string(canvas.height()) +
                (canvas.begin() ? "" : ", nullptr"),
            &canvas, canvas.begin()};
}

using Caller = std::function<Call()>;

Canvas marked(Canvas canvas, Program& program, const Caller& main) {
    const auto stack = [&] {
        return std::vector{main(), Call{"marked", {variable("canvas", canvas)}}};
    };
    program.ran(0, "A call: a frame with canvas, which is made by a move. It takes the block of a.",
                stack());
    canvas.at(0, 0).value = 9;
    program.ran(1, "The first pixel changes. It belongs to canvas now.", stack());
    return canvas;
}

// The learner's canvas runs here.
Program run_canvases() {
    Program program;
    program.lines = {"Canvas<int> marked(Canvas<int> canvas) {",
                     "    canvas.at(0, 0) = 9;",
                     "    return canvas;",
                     "}",
                     "",
                     "int main() {",
                     "    Canvas<int> a{3, 2, 5};",
                     "    Canvas<int> b = a;",
                     "    Canvas<int> c = marked(std::move(a));",
                     "    {",
                     "        Canvas<int> d{2, 1, 4};",
                     "    }",
                     "    a = b;",
                     "}"};
    heap = {};
    program.ran(-1, "Nothing has run yet.", {});
    program.ran(5, "A frame for main, still without variables.", {{"main", {}}});
    {
        Canvas a{3, 2, {5}};
        program.ran(6, "A constructor: a is on the stack, and its pixels are on the heap.",
                    {{"main", {variable("a", a)}}});
        Canvas b = a;
        const Caller two = [&] { return Call{"main", {variable("a", a), variable("b", b)}}; };
        program.ran(7, "The copy constructor: b gets pixels of its own.", {two()});
        Canvas c = marked(std::move(a), program, two);
        const Caller three = [&] {
            Call call = two();
            call.variables.push_back(variable("c", c));
            return call;
        };
        program.ran(8, "The return moves canvas into c, and takes the frame off. a stays empty.",
                    {three()});
        {
            Canvas d{2, 1, {4}};
            Call call = three();
            call.variables.push_back(variable("d", d));
            program.ran(10, "Another canvas, in a block.", {call});
        }
        program.ran(11, "The closing brace: the destructor of d gives its pixels back.", {three()});
        a = b;
        program.ran(12, "An assignment: a gets a copy, in the place that is free again.",
                    {three()});
    }
    program.ran(13, "The closing brace of main: three destructors, and the heap is empty.", {});
    return program;
}

// Says so when it comes and when it goes.
struct Guest {
    Program& program;

    explicit Guest(Program& its_program) : program{its_program} {
        program.printed.push_back("  hello");
    }
    ~Guest() { program.printed.push_back("  goodbye"); }
};

// The text's pointers.cpp. Nothing of it is on the heap.
Program run_pointers() {
    Program program;
    program.lines = {"int main() {",
                     "    int x = 5;",
                     "    int* p = &x;",
                     "    int& r = x;",
                     "    std::cout << \"x is at \" << &x << …;",
                     "    *p = 7;",
                     "    r = r + 1;",
                     "    std::cout << \"now x is \" << x << '\\n';",
                     "    {",
                     "        Guest guest;",
                     "        std::cout << \"  inside the block\\n\";",
                     "    }",
                     "    std::cout << \"after it\\n\";",
                     "}"};
    heap = {};
    program.ran(-1, "Nothing has run yet.", {});
    program.ran(0, "A frame for main, still without variables.", {{"main", {}}});
    int x = 5;
    program.ran(1, "x has a place on the stack.", {{"main", {{"x", "5", &x}}}});
    int* p = &x;
    const auto stack = [&](const char* name) {
        return std::vector{Call{"main", {{name, std::to_string(x), &x}, {"p", hex(p), &p, p}}}};
    };
    program.ran(2, "p has its own place, and holds the address of x.", stack("x"));
    int& r = x;
    program.ran(3, "r is another name for x, at the same place.", stack("x, r"));
    program.printed.push_back("x is at " + hex(&x) + ", p holds " + hex(p));
    program.printed.push_back("and there lies " + std::to_string(*p));
    program.ran(4, "The address of x, what p holds, and what is stored there.", stack("x, r"));
    *p = 7;
    program.ran(5, "*p is what p points to, so x changes.", stack("x, r"));
    r = r + 1;
    program.ran(6, "r is x, so x changes.", stack("x, r"));
    program.printed.push_back("now x is " + std::to_string(x));
    program.ran(7, "x is 8, although no line says so.", stack("x, r"));
    {
        Guest guest{program};
        auto with_guest = stack("x, r");
        with_guest[0].variables.push_back({"guest", "", &guest});
        program.ran(9, "The constructor of guest says hello.", with_guest);
        program.printed.push_back("  inside the block");
        program.ran(10, "guest lives until the block’s closing brace.", with_guest);
    }
    program.ran(11, "The closing brace: the destructor of guest says goodbye.", stack("x, r"));
    program.printed.push_back("after it");
    program.ran(12, "x, p and r are still there.", stack("x, r"));
    program.ran(13, "The closing brace of main takes its frame off.", {});
    return program;
}

struct MemoryLayout {
    double row, letters;       // of the listing
    Point stack, heap;         // the upper left corners
    double stack_width, side;  // side: of a pixel
};

MemoryLayout memory_layout(double width) {
    if (width < 520)
        return {18, 11.5, {1, 14 * 18 + 36}, {0.57 * width, 14 * 18 + 36}, 0.47 * width, 22};
    return {21, 13, {0.47 * width, 26}, {0.78 * width, 26}, 0.24 * width, 26};
}

void draw_listing(Drawing& out, const MemoryLayout& layout, const Program& program, int line) {
    const double right = out.is_narrow() ? out.width : 0.44 * out.width;
    out.code = true, out.text_size = layout.letters;
    for (std::size_t i = 0; i < program.lines.size(); ++i) {
        const double y = layout.row * static_cast<double>(i);
        const bool runs = static_cast<int>(i) == line;
        if (runs) {
            out.box({0, y}, {right, y + layout.row}, thin(amber, 0.25));
            out.box({0, y}, {3, y + layout.row}, amber);
        }
        const std::size_t indent =
            std::min(program.lines[i].find_first_not_of(' '), program.lines[i].size());
        out.text({8 + 0.6 * layout.letters * static_cast<double>(indent), y + layout.row / 2},
                 program.lines[i].substr(indent), ink, Align::left);
    }
    out.code = false, out.text_size = 13;
}

// Where an arrow ends: the middle of the left side of each block, and the right side of each row.
struct Places {
    std::vector<std::pair<const void*, Point>> all;

    const Point* find(const void* address) const {
        for (const auto& [at, point] : all)
            if (at == address) return &point;
        return nullptr;
    }
};

double draw_blocks(Drawing& out, const MemoryLayout& layout, const State& state, Places& places) {
    constexpr double pitch = 82;
    for (std::size_t i = 0; i < 3; ++i) {
        const Block& block = state.blocks[i];
        const Point corner = layout.heap + Point{0, pitch * static_cast<double>(i)},
                    grid = corner + Point{0, 18};
        out.text_size = 11;
        out.text(corner + Point{0, 9}, hex(block.address), muted, Align::left);
        out.text_size = 13;
        if (block.pixels.empty()) {
            out.frame(grid, grid + Point{3 * layout.side, 2 * layout.side}, {faint, 1.2, 4});
            out.text(grid + Point{1.5 * layout.side, layout.side}, "free", muted);
            continue;
        }
        places.all.push_back({block.address, grid + Point{-4, layout.side / 2}});
        const std::size_t columns = std::min<std::size_t>(3, block.pixels.size());
        for (std::size_t k = 0; k < block.pixels.size(); ++k) {
            const Point at = grid + layout.side * Point{static_cast<double>(k % columns),
                                                        static_cast<double>(k / columns)},
                        end = at + Point{layout.side, layout.side};
            out.box(at, end, thin(green, 0.22));
            out.frame(at, end, {green, 1.2});
            out.text(0.5 * (at + end), "{}", ink, Align::middle, block.pixels[k]);
        }
    }
    return layout.heap.y + 3 * pitch;
}

void draw_stack(Drawing& out, const MemoryLayout& layout, const State& state, Places& places,
                bool has_heap) {
    const double row = 25, right = layout.stack.x + layout.stack_width;
    double y = layout.stack.y;
    struct Arrow {
        Point from;
        const void* to;
    };
    std::vector<Arrow> arrows;
    for (const Call& call : state.stack) {
        const double high = 24 + row * static_cast<double>(call.variables.size());
        out.box({layout.stack.x, y}, {right, y + high}, thin(blue, 0.12));
        out.frame({layout.stack.x, y}, {right, y + high}, {blue, 1.4});
        out.code = true, out.text_size = 12;
        out.text({layout.stack.x + 8, y + 13}, call.function + "()", blue, Align::left);
        double at = y + 24 + row / 2;
        for (const Variable& one : call.variables) {
            out.text({layout.stack.x + 16, at},
                     one.value.empty() ? one.name : one.name + ": " + one.value, ink, Align::left);
            // Where there is room for it, its address.
            if (out.is_narrow() ? !has_heap && !one.target : !has_heap || one.target) {
                out.text_size = 11;
                out.text({right - (has_heap ? 22 : 8), at}, hex(one.address), muted, Align::right);
                out.text_size = 12;
            }
            places.all.push_back({one.address, {right + 2, at}});
            if (one.target) arrows.push_back({{right - (has_heap ? 10 : 0), at}, one.target});
            at += row;
        }
        out.code = false, out.text_size = 13;
        y += high + 8;
    }
    for (const Arrow& arrow : arrows) {
        const Point* const to = places.find(arrow.to);
        if (!to) continue;
        if (has_heap) {
            out.dot(arrow.from, accent, 3.5);
            out.arrow(arrow.from, *to, {accent, 1.8});
        } else {
            const double side = right + 18;
            out.path({arrow.from, {side, arrow.from.y}, {side, to->y}}, {accent, 1.8});
            out.arrow({side, to->y}, *to, {accent, 1.8});
        }
    }
}

// What the program prints, as far as it has run; the room is for all of it.
double draw_printed(Drawing& out, const MemoryLayout& layout,
                    std::span<const std::string> printed) {
    const Point corner = layout.stack + Point{0, 134};
    constexpr double row = 17;
    out.text(corner, "Printed:", muted, Align::left);
    out.code = true, out.text_size = 12;
    for (std::size_t i = 0; i < printed.size(); ++i)
        out.text(corner + Point{printed[i].starts_with("  ") ? 14.0 : 0.0,
                                19 + row * static_cast<double>(i)},
                 printed[i], ink, Align::left);
    out.code = false, out.text_size = 13;
    return corner.y + 19 + 7 * row;
}

}  // namespace

void draw(const MemoryControls& c, Drawing& out) {
    const bool has_heap = c.program == 0;
    const Program program = has_heap ? run_canvases() : run_pointers();
    const std::size_t last = program.states.size() - 1,
                      step = std::min(last, static_cast<std::size_t>(c.step));
    const State& state = program.states[step];
    const MemoryLayout layout = memory_layout(out.width);
    draw_listing(out, layout, program, state.line);
    Places places;
    out.bold = true;
    out.text(layout.stack + Point{0, -13}, "Stack", blue, Align::left);
    out.text(layout.heap + Point{0, -13}, "Heap", green, Align::left);
    out.bold = false;
    out.height = 14 * layout.row;
    if (has_heap) {
        out.height = std::max(out.height, draw_blocks(out, layout, state, places)) + 4;
    } else {
        out.text(layout.heap + Point{0, 10}, "nothing", muted, Align::left);
        out.height = std::max(out.height, draw_printed(out, layout, state.printed));
    }
    draw_stack(out, layout, state, places, has_heap);
    out.handle_everywhere();
    std::string words = "Step {} of {}. " + std::string{state.what};
    if (has_heap && step > 0) {
        const auto now = std::count_if(state.blocks.begin(), state.blocks.end(),
                                       [](const Block& block) { return !block.pixels.empty(); });
        out.say(words + " Blocks allocated so far: {}; on the heap now: {}.", step, last,
                state.allocated, now);
    } else {
        out.say(words, step, last);
    }
}

void drag(MemoryControls& c, const Drag& to) {
    c.step = std::round(c.step + 16 * to.moved().x / to.width);
}

}  // namespace live
