#include <algorithm>
#include <companion/check/recognition.hpp>

namespace companion {
namespace {

// With these values, every mistake except one, whose failure depends on chance, is recognized as
// itself or as one with the same signature. In a trial with the 247 mistakes of that time, each in
// turn was left out of the list and then made: 4 were taken for a single mistake that differs
// little, and none for a pair; 8 more had the same signature as another mistake.
constexpr double alike_enough = 0.75, clearly_more = 0.1;

// The mistakes of an exercise that share one signature, and how similar an answer is to it.
struct Candidate {
    LookAlikes names;
    const Signature* signature;
    double likeness;
};

Signature together(const Signature& a, const Signature& b) {
    Signature both = a;
    both.where.insert(b.where.begin(), b.where.end());
    both.what.insert(b.what.begin(), b.what.end());
    keep_sample(both.what);
    return both;
}

// The candidates for an exercise, the most similar first.
std::vector<Candidate> candidates(const Signatures& known, const std::string& exercise,
                                  const Signature& signature) {
    std::vector<Candidate> found;
    for (const auto& [name, candidate] : known) {
        if (name.rfind(exercise + '_', 0) != 0) continue;
        const auto twin = std::find_if(
            found.begin(), found.end(),
            [&, &like = candidate](const Candidate& other) { return *other.signature == like; });
        if (twin != found.end())
            twin->names.push_back(name);
        else
            found.push_back({{name}, &candidate, similarity(candidate, signature)});
    }
    std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
        return a.likeness > b.likeness;
    });
    return found;
}

}  // namespace

std::vector<LookAlikes> recognize(const Signatures& known, const std::string& exercise,
                                  const Signature& signature) {
    if (signature.where.empty()) return {};
    const std::vector<Candidate> single = candidates(known, exercise, signature);
    if (single.empty()) return {};
    const double next = single.size() > 1 ? single[1].likeness : 0, most = single[0].likeness;
    if (*single[0].signature == signature) return {single[0].names};
    if (most >= alike_enough && most - next >= clearly_more) return {single[0].names};

    // Two mistakes at once, such as the same slip in two functions.
    std::vector<LookAlikes> pair;
    double best = 0;
    for (std::size_t a = 0; a < single.size(); ++a)
        for (std::size_t b = a + 1; b < single.size(); ++b) {
            const double likeness =
                similarity(together(*single[a].signature, *single[b].signature), signature);
            if (likeness > best) {
                best = likeness;
                pair = {single[a].names, single[b].names};
            }
        }
    if (best >= alike_enough && best - most >= clearly_more) return pair;
    return {};
}

}  // namespace companion
