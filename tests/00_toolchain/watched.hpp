#pragma once
// A pixel and a node that report what happens to them and to their memory. The test cases and the
// answer make and destroy them; the Watch that they report to is the test cases' (watch.hpp).

#include <cstddef>
#include <memory>
#include <new>

namespace checkpoint {

// Who is told; nobody, as long as there is no Watch.
struct Listener {
    void* (*take)(std::size_t) = [](std::size_t size) { return ::operator new(size); };
    void (*release)(void*) = [](void* block) { ::operator delete(block); };
    void (*begin)(const void*) = [](const void*) {};
    void (*end)(const void*) = [](const void*) {};
    void (*use)(const void*) = [](const void*) {};
    void (*copy_from)(const void*) = [](const void*) {};
    void (*copied_by_bytes)() = [] {};
    void (*destructor_begins)() = [] {};
    void (*destructor_ends)() = [] {};
};

// There are two, that of the test cases and that of the answer. A Watch sets both.
inline Listener listener;

// A pixel that is watched.
class WatchedPixel {
  public:
    WatchedPixel(int value = 0) : value_{value} { listener.begin(this); }
    WatchedPixel(const WatchedPixel& other) : value_{other.value_} {
        listener.copy_from(&other);
        listener.begin(this);
    }
    WatchedPixel& operator=(const WatchedPixel& other) {
        listener.use(this);
        listener.copy_from(&other);
        value_ = other.value_;
        return *this;
    }
    ~WatchedPixel() { listener.end(this); }

    int value() const {
        listener.use(this);
        if (self_ != this) listener.copied_by_bytes();
        return value_;
    }
    friend bool operator==(const WatchedPixel& a, const WatchedPixel& b) {
        return a.value() == b.value();
    }
    friend bool operator<(const WatchedPixel& a, const WatchedPixel& b) {
        return a.value() < b.value();
    }

    static void* operator new(std::size_t size) { return listener.take(size); }
    static void* operator new[](std::size_t size) { return listener.take(size); }
    static void* operator new(std::size_t, void* place) { return place; }
    static void operator delete(void* block) { listener.release(block); }
    static void operator delete[](void* block) { listener.release(block); }

  private:
    int value_;
    const WatchedPixel* self_ = this;  // its own address, which objects of some types store
};

// A node of a tree that is watched.
class WatchedNode {
    // Destroyed after the children: a destructor that runs in between runs inside this one.
    struct End {
        ~End() { listener.destructor_ends(); }
    } end_;

  public:
    WatchedNode(int first_thing, int end) : first{first_thing}, last{end} { listener.begin(this); }
    WatchedNode(const WatchedNode&) = delete;
    WatchedNode& operator=(const WatchedNode&) = delete;
    ~WatchedNode() {
        listener.end(this);
        listener.destructor_begins();
    }

    static void* operator new(std::size_t size) { return listener.take(size); }
    static void operator delete(void* block) { listener.release(block); }

    int first, last;
    std::unique_ptr<WatchedNode> left, right;
};

}  // namespace checkpoint
