#include <algorithm>
#include <cmath>
#include <companion/follow/trail.hpp>
#include <cstdio>
#include <numbers>
#include <optional>
#include <rt/counted.hpp>

namespace companion {
namespace {

constexpr int most_told = 20, told_of_many = 6;  // rays; of more, the first ones and the last

std::string text_of(double number) {
    if (std::isnan(number)) return "not a number";
    if (std::isinf(number)) return number > 0 ? "infinity" : "-infinity";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number == 0 ? 0 : number);
    return text;
}

std::string text_of(rt::Vec3 v) {
    return '(' + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ')';
}

// "0.25", "0.25 and 0.5", "0.25, 0.5 and 0.75"
std::string list_of(const std::vector<double>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        text += (i == 0 ? "" : i + 1 < numbers.size() ? ", " : " and ") + text_of(numbers[i]);
    return text;
}

std::string degrees_between(rt::Vec3 a, rt::Vec3 b) {
    const double cosine = dot_of(a, b) / (length_of(a) * length_of(b));
    if (std::isnan(cosine)) return "an unknown angle";
    char text[32];
    std::snprintf(text, sizeof text, "%.1f degrees",
                  std::acos(std::fmin(1, std::fmax(-1, cosine))) * 180 / std::numbers::pi);
    return text;
}

// A direction; its length, too, if it is not 1.
std::string direction_text(rt::Vec3 v) {
    const double length = length_of(v);
    return text_of(v) + (std::abs(length - 1) < 1e-6 ? "" : ", of length " + text_of(length));
}

rt::Vec3 product_of(rt::Vec3 a, rt::Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

class Teller {
  public:
    explicit Teller(int rays) : all_{rays} {}
    void tell(const TrailStep& step);
    std::string text() const { return text_; }

  private:
    bool is_left_out() const { return all_ > most_told && rays_ > told_of_many && rays_ < all_; }
    void line(const std::string& words) {
        if (!is_left_out()) text_ += "     " + words + '\n';
    }
    void ray(const TrailStep& step);
    void hit(const TrailStep& step);
    void scatter(const TrailStep& step);
    void shadow(const TrailStep& step);

    std::string text_, last_;
    std::size_t depth_ = 0;
    int all_, rays_ = 0;
    rt::Vec3 direction_;             // of the last ray
    std::optional<rt::Vec3> point_;  // where it ended
    bool on_surface_ = false;        // whether that is on a surface
    rt::Vec3 outward_, facing_;      // the surface's normal; the same on the ray's side
    rt::Vec3 product_{1, 1, 1};      // of the attenuations
    bool asks_lamp_ = false;
};

// Where a ray begins, seen from the point where the last one ended.
void Teller::ray(const TrailStep& step) {
    const rt::Vec3 origin = step.vector("origin");
    std::string from = "from " + text_of(origin);
    if (point_) {
        const std::string point = "point " + std::to_string(rays_);
        const rt::Vec3 off = along(origin, -1, *point_);
        from = off == rt::Vec3{} ? "from " + point + " itself"
                                 : "from " + point + ", moved by " + text_of(length_of(off)) +
                                       (!on_surface_                ? ""
                                        : dot_of(off, outward_) > 0 ? " outward"
                                                                    : " inward");
    }
    direction_ = step.vector("direction");
    ++rays_;
    if (is_left_out()) {
        if (rays_ == told_of_many + 1) text_ += "   ...\n";
        return;
    }
    char number[16];
    std::snprintf(number, sizeof number, "%4d ", rays_);
    text_ += number + from + " along " + direction_text(direction_) + '\n';
}

void Teller::hit(const TrailStep& step) {
    point_ = step.vector("point");
    on_surface_ = step.has("normal");
    line("meets " +
         (step.has("radius")
              ? "sphere " + step.text("number") + ", of radius " + text_of(step.number("radius")) +
                    " around " + text_of(step.vector("center"))
              : std::string{"a shape that is no plain sphere"}) +
         ", at t = " + text_of(step.number("t")));
    if (!on_surface_) return line("point " + text_of(*point_));
    const bool front = step.number("front") != 0;
    outward_ = step.vector("normal");
    facing_ = front ? outward_ : along({}, -1, outward_);
    line(std::string{front ? "from outside" : "from inside"} + ", at " +
         degrees_between(facing_, along({}, -1, direction_)) + " from the normal");
    line("point " + text_of(*point_) + ", normal " + direction_text(outward_));
    if (step.number("lamp") >= 0) line("which is lamp " + step.text("lamp"));
}

void Teller::scatter(const TrailStep& step) {
    const rt::Vec3 direction = step.vector("direction"), share = step.vector("attenuation");
    std::string words = "goes on along " + direction_text(direction);
    if (on_surface_) {
        const bool through = dot_of(facing_, direction) < 0;
        words += ", at " + degrees_between(through ? along({}, -1, facing_) : facing_, direction) +
                 " from the normal" + (through ? ", through the surface" : "");
    }
    line(words);
    product_ = product_of(product_, share);
    line("attenuation " + text_of(share) + "; all of them so far multiply to " + text_of(product_));
}

void Teller::shadow(const TrailStep& step) {
    const double t = step.number("meets");
    const bool is_free = step.has("meets") ? std::isinf(t) : step.number("blocked") == 0;
    line("a lamp lies along " + direction_text(step.vector("direction")) + ", " +
         text_of(step.number("distance")) + " away, and " +
         (is_free             ? "nothing is in the way"
          : step.has("meets") ? "the way there meets something at t = " + text_of(t)
                              : "something is in the way"));
    asks_lamp_ = true;
}

void Teller::tell(const TrailStep& step) {
    const std::string& name = step.name;
    if (name == "camera") {
        const std::vector<double> offset = step.numbers("offset");
        text_ += "The first ray goes through the pixel at (" + text_of(offset.at(0)) + ", " +
                 text_of(offset.at(1)) + "); its top left corner is (0, 0).\n";
    }
    if (name == "path") depth_ = static_cast<std::size_t>(step.number("depth"));
    if (name == "ray") ray(step);
    if (name == "miss") line("meets nothing");
    if (name == "hit") hit(step);
    if (name == "fog") {
        point_ = step.vector("point");
        on_surface_ = false;
        line("but a droplet of fog comes first, at t = " + text_of(step.number("t")) + ", point " +
             text_of(*point_));
    }
    if (name == "material") line(step.text("name"));
    if (name == "of" && !is_left_out())
        for (const auto& [field, value] : step.fields) {
            const bool is_color = step.numbers(field).size() == 3;
            text_.insert(text_.size() - 1, ", " + field + ' ' +
                                               (is_color ? text_of(step.vector(field))
                                                         : text_of(step.number(field))));
        }
    if (name == "random") {
        const std::vector<double> numbers = step.numbers("numbers");
        line("draws the random number" + std::string(numbers.size() == 1 ? " " : "s ") +
             list_of(numbers));
    }
    if (name == "scatter") scatter(step);
    if (name == "absorbed") line("is absorbed");
    if (name == "shadow") shadow(step);
    if (name == "lamp") {
        const rt::Vec3 light = step.vector("color");
        line((asks_lamp_ ? "the lamp's share is " : "no ray to a lamp; its share is ") +
             text_of(light) + ", with the attenuations " + text_of(product_of(light, product_)));
        asks_lamp_ = false;
    }
    if (name == "limit") {
        const std::string ends = step.text("ends");
        line("the limit of " + rt::counted(depth_, "bounce") + " is reached: the path " +
             (ends == "none" ? "goes on" : "ends in " + (ends == "sky" ? "the " + ends : ends)) +
             ", with the throughput " + text_of(step.vector("throughput")));
    }
    if (name == "sky")
        line("the sky's light from " + direction_text(step.vector("direction")) + " is " +
             text_of(step.vector("color")));
    if (name == "endless")
        text_ += "More than " + step.text("segments") + " segments: stopped here.\n";
    if (name == "light")
        text_ += "The light of this sample: " + text_of(step.vector("color")) + '\n';
    if (name == "haze") text_ += "Seen through the haze: " + text_of(step.vector("color")) + '\n';
    if (name == "end" && last_ == "ray") line("is tested against no sphere");
    last_ = name;
}

}  // namespace

std::string in_words(const Trail& trail) {
    const auto rays = std::count_if(trail.begin(), trail.end(),
                                    [](const TrailStep& step) { return step.name == "ray"; });
    Teller teller{static_cast<int>(rays)};
    for (const TrailStep& step : trail) teller.tell(step);
    return teller.text();
}

}  // namespace companion
