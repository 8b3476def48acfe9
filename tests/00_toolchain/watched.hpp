#pragma once
// How the checkpoints of this chapter watch memory: with a pixel and a node that record when they
// are made, copied and destroyed. Memory that is released is kept until the end of the test case,
// so that wrong code, which uses it later or releases it twice, fails instead of crashing.

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <new>
#include <set>

namespace checkpoint {

// For one test case: declare it first, so that it is destroyed last.
class Watch {
  public:
    Watch() {
        forget();
        released_twice = dead_uses = byte_copies = copies = made = deepest_destructor = 0;
        most_live = 0;
        asked = 0;
        is_full = false;
    }
    ~Watch() { forget(); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    // Objects and blocks of memory that have been made and not destroyed.
    static int live_objects() { return static_cast<int>(objects.size()); }
    static int live_blocks() {
        return static_cast<int>(
            std::count_if(blocks.begin(), blocks.end(), [](const auto& b) { return b.second; }));
    }

    inline static int released_twice = 0;      // objects and blocks
    inline static int dead_uses = 0;           // of a destroyed object
    inline static int byte_copies = 0;         // uses of an object that was copied byte by byte
    inline static int copies = 0;              // of objects
    inline static int made = 0;                // objects, copies among them
    inline static int most_live = 0;           // objects that existed at the same time
    inline static int deepest_destructor = 0;  // destructors that ran inside each other
    inline static std::size_t asked = 0;       // bytes of the last block that was asked for
    inline static bool is_full = false;        // the heap: new throws

    static void* take(std::size_t size) {
        asked = size;
        void* const block = is_full ? nullptr : std::malloc(size ? size : 1);
        if (!block) throw std::bad_alloc{};
        blocks[block] = true;
        return block;
    }
    static void release(void* block) {
        if (!block) return;
        const auto found = blocks.find(block);
        if (found == blocks.end() || !found->second)
            ++released_twice;
        else
            found->second = false;  // and its memory stays
    }
    static void begin(const void* object) {
        objects.insert(object);
        ++made;
        most_live = std::max(most_live, live_objects());
    }
    static void end(const void* object) {
        if (objects.erase(object) == 0) ++released_twice;
    }
    static void use(const void* object) { dead_uses += objects.count(object) == 0; }
    static void copy_from(const void* object) {
        use(object);
        ++copies;
    }

  private:
    static void forget() {
        for (const auto& block : blocks) std::free(block.first);
        blocks.clear();
        objects.clear();
    }

    inline static std::map<void*, bool> blocks;  // is it in use?
    inline static std::set<const void*> objects;
};

// A pixel that is watched.
class WatchedPixel {
  public:
    WatchedPixel(int value = 0) : value_{value} { Watch::begin(this); }
    WatchedPixel(const WatchedPixel& other) : value_{other.value_} {
        Watch::copy_from(&other);
        Watch::begin(this);
    }
    WatchedPixel& operator=(const WatchedPixel& other) {
        Watch::use(this);
        Watch::copy_from(&other);
        value_ = other.value_;
        return *this;
    }
    ~WatchedPixel() { Watch::end(this); }

    int value() const {
        Watch::use(this);
        Watch::byte_copies += self_ != this;
        return value_;
    }
    friend bool operator==(const WatchedPixel& a, const WatchedPixel& b) {
        return a.value() == b.value();
    }
    friend bool operator<(const WatchedPixel& a, const WatchedPixel& b) {
        return a.value() < b.value();
    }

    static void* operator new(std::size_t size) { return Watch::take(size); }
    static void* operator new[](std::size_t size) { return Watch::take(size); }
    static void* operator new(std::size_t, void* place) { return place; }
    static void operator delete(void* block) { Watch::release(block); }
    static void operator delete[](void* block) { Watch::release(block); }

  private:
    int value_;
    const WatchedPixel* self_ = this;  // its own address, which objects of some types store
};

// A node of a tree that is watched.
class WatchedNode {
    // Destroyed after the children: a destructor that runs in between runs inside this one.
    struct Level {
        ~Level() { --depth; }
        inline static int depth = 0;
    } level_;

  public:
    WatchedNode(int first_thing, int end) : first{first_thing}, last{end} { Watch::begin(this); }
    WatchedNode(const WatchedNode&) = delete;
    WatchedNode& operator=(const WatchedNode&) = delete;
    ~WatchedNode() {
        Watch::end(this);
        Watch::deepest_destructor = std::max(Watch::deepest_destructor, ++Level::depth);
    }

    static void* operator new(std::size_t size) { return Watch::take(size); }
    static void operator delete(void* block) { Watch::release(block); }

    int first, last;
    std::unique_ptr<WatchedNode> left, right;
};

}  // namespace checkpoint
