#pragma once
// How the checkpoints of this chapter watch memory. Memory that is released is kept until the end
// of the test case, so that wrong code, which uses it later or releases it twice, fails instead of
// crashing.

#include <algorithm>
#include <cstdlib>
#include <map>
#include <new>
#include <set>

#include "watched.hpp"

namespace answer {

// From now on, the answer's objects report to this one.
void report_to(const checkpoint::Listener& listener);

}  // namespace answer

namespace checkpoint {

// For one test case: declare it first, so that it is destroyed last.
class Watch {
  public:
    // Objects by the million are better not recorded one by one.
    enum Kind { everything, destructors_only };
    explicit Watch(Kind kind = everything) {
        forget();
        released_twice = dead_uses = byte_copies = copies = made = deepest_destructor = 0;
        most_live = 0;
        asked = 0;
        is_full = false;
        listener = {};
        if (kind == everything)
            listener = {take, release, begin, end, use, copy_from, copied_by_bytes};
        listener.destructor_begins = destructor_begins;
        listener.destructor_ends = destructor_ends;
        answer::report_to(listener);
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

  private:
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
    static void copied_by_bytes() { ++byte_copies; }
    static void destructor_begins() {
        deepest_destructor = std::max(deepest_destructor, ++destructors);
    }
    static void destructor_ends() { --destructors; }

    static void forget() {
        for (const auto& block : blocks) std::free(block.first);
        blocks.clear();
        objects.clear();
    }

    inline static std::map<void*, bool> blocks;  // is it in use?
    inline static std::set<const void*> objects;
    inline static int destructors = 0;  // that run now
};

}  // namespace checkpoint
