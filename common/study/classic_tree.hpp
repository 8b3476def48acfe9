#pragma once
// The tree of the baseline (see classic.hpp). Its nodes are objects like any other, and so is the
// list that contains the tree.

#include <limits>

#include <study/classic_objects.hpp>

namespace study::classic {

using Objects = std::vector<std::shared_ptr<Hittable>>;

// The objects are sorted along the longest axis, and each child gets half of them; the left child
// is visited first.
class Node : public Hittable {
  public:
    Node(Objects& objects, std::size_t first, std::size_t last) {
        bounds_ = objects[first]->bounds();
        for (std::size_t i = first; i < last; ++i) bounds_ = join(bounds_, objects[i]->bounds());
        const int axis = bounds_.longest_axis();
        const std::size_t count = last - first;
        if (count == 1) {
            left_ = right_ = objects[first];
        } else if (count == 2) {
            left_ = objects[first];
            right_ = objects[first + 1];
        } else {
            const auto begin = objects.begin();
            std::sort(begin + static_cast<std::ptrdiff_t>(first),
                      begin + static_cast<std::ptrdiff_t>(last),
                      [axis](const auto& a, const auto& b) {
                          return a->bounds().along(axis).min < b->bounds().along(axis).min;
                      });
            const std::size_t middle = first + count / 2;
            left_ = std::make_shared<Node>(objects, first, middle);
            right_ = std::make_shared<Node>(objects, middle, last);
        }
    }
    bool hit(const Ray& ray, Range within, HitRecord& record) const override {
        if (!bounds_.hit(ray, within)) return false;
        const bool left = left_->hit(ray, within, record);
        const bool right = right_->hit(ray, {within.min, left ? record.t : within.max}, record);
        return left || right;
    }
    Bounds bounds() const override { return bounds_; }

  private:
    std::shared_ptr<Hittable> left_, right_;
    Bounds bounds_;
};

// A list of objects. The world is a list whose only member is the tree.
class List : public Hittable {
  public:
    explicit List(Objects objects) : objects_{std::move(objects)} {}

    bool hit(const Ray& ray, Range within, HitRecord& record) const override {
        HitRecord found;
        bool any = false;
        for (const auto& object : objects_)
            if (object->hit(ray, within, found)) {
                any = true;
                within.max = found.t;
                record = found;
            }
        return any;
    }
    Bounds bounds() const override {
        Bounds all = objects_.front()->bounds();
        for (const auto& object : objects_) all = join(all, object->bounds());
        return all;
    }

  private:
    Objects objects_;
};

}  // namespace study::classic
