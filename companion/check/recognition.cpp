#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <companion/check/recognition.hpp>
#include <companion/system/files.hpp>

namespace companion {
namespace {

using app::Json;

// All mistakes except one, whose failure depends on chance, are recognized as themselves or as one
// with the same signature. A trial left each of the 247 mistakes of that time out of the list in
// turn, and then made it: 4 were taken for another that differs little, none for a pair; 8 more had
// a twin.
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

// The candidates for an exercise, the most alike first.
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

// The hashes stored in the file under this key of a signature.
std::set<std::string> hashes(const Json& signature, const std::string& key, const fs::path& file) {
    const Json* const list = app::find(signature, key, Json::Kind::list);
    if (!list) throw app::Failure(file.string() + ": a signature has no list '" + key + '\'');
    std::set<std::string> found;
    for (const Json& hash : list->items) found.insert(hash.text);
    return found;
}

Json list(const std::set<std::string>& hashes) {
    Json json{Json::Kind::list};
    for (const std::string& hash : hashes) json.items.push_back({Json::Kind::text, 0, hash});
    return json;
}

}  // namespace

fs::path signatures_file(const Course& course, const Chapter& chapter) {
    return course.root / "tests/mistakes" / chapter.name / "signatures.json";
}

Signatures read_signatures(const Course& course, const Chapter& chapter) {
    const fs::path file = signatures_file(course, chapter);
    if (!fs::exists(file)) return {};
    Signatures signatures;
    const Json json = [&] {
        try {
            return app::parse_json(read_file(file), file.string());
        } catch (const app::UsageError& error) {  // not written by the user
            throw app::Failure(error.what());
        }
    }();
    for (std::size_t i = 0; i < json.keys.size(); ++i) {
        Signature& signature = signatures[json.keys[i]];
        signature.where = hashes(json.items[i], "where", file);
        signature.what = hashes(json.items[i], "what", file);
    }
    return signatures;
}

// One line per mistake: a change to one mistake changes one line.
std::string to_text(const Signatures& signatures) {
    std::string text;
    for (const auto& [name, signature] : signatures) {
        text += text.empty() ? "{\n" : ",\n";
        text += app::to_text({Json::Kind::text, 0, name}) + ": " +
                app::to_text({Json::Kind::object,
                              0,
                              {},
                              {list(signature.what), list(signature.where)},
                              {"what", "where"}});
    }
    return text.empty() ? "{}\n" : text + "\n}\n";
}

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
