#pragma once
// What all plots are made of.

#include <companion/pages/axis.hpp>
#include <companion/pages/captions.hpp>
#include <string>
#include <vector>

namespace companion {

// The width of a plot, narrow enough that its letters can be read on a phone.
constexpr double plot_width = 520;
constexpr std::size_t color_count = 7;

// How the points of one variant look.
struct Look {
    std::size_t color, shape;
    double line, dot;  // their sizes
};

std::string point(double x, double y);

// Words at a place; `attributes` begin with a space.
std::string svg_text(double x, double y, const std::string& words,
                     const std::string& attributes = "");
inline const std::string in_the_middle = " text-anchor='middle'",
                         to_the_left = " text-anchor='end'";

// Words as lines of at most so many letters, as far as spaces allow it.
std::vector<std::string> wrapped(const std::string& words, std::size_t letters);

// The text that appears when the pointer is on a part.
std::string svg_title(const std::string& says);

// A dot of one of six shapes.
std::string svg_dot(const Look& look, double x, double y, const std::string& says = "");

// The title at the top of a panel, from `y` on, which becomes the place below it.
std::string heading(double& y, const std::string& words);

// The lines, values and name of a horizontal axis at the bottom of a panel, whose lines go up to
// `top`.
std::string axis_below(const Axis& x, double bottom, double top, const std::string& name);

// The same for a vertical axis on the left. Its name stands above it, so that it can be read like
// any text.
std::string axis_beside(const Axis& y, double left, double right, const std::string& name);

// A whole picture of these parts, with its name for those who cannot see it.
std::string picture(const std::string& study, const std::string& name, const std::string& parts,
                    double height);

}  // namespace companion
