#include <app/errors.hpp>
#include <course/files.hpp>
#include <course/mistakes.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

namespace course {
namespace {

using Json = nlohmann::json;

// Found by trying: see tests/course/mistakes.cpp.
constexpr double alike_enough = 0.5, clearly_more = 0.1;

}  // namespace

fs::path signatures_file(const Course& course, const Chapter& chapter) {
    return course.root / "tests/mistakes" / chapter.name / "signatures.json";
}

Signatures read_signatures(const Course& course, const Chapter& chapter) {
    const fs::path file = signatures_file(course, chapter);
    if (!fs::exists(file)) return {};
    Signatures signatures;
    try {
        const Json json = Json::parse(read_file(file));
        for (const auto& [name, signature] : json.items()) {
            signature.at("where").get_to(signatures[name].where);
            signature.at("what").get_to(signatures[name].what);
        }
    } catch (const Json::exception& error) {
        throw app::Failure(file.string() + " cannot be read: " + error.what());
    }
    return signatures;
}

// A line a mistake, so that a change of one is a change of one line.
std::string to_text(const Signatures& signatures) {
    std::string text;
    for (const auto& [name, signature] : signatures) {
        text += text.empty() ? "{\n" : ",\n";
        text += Json(name).dump() + ": " +
                Json{{"where", signature.where}, {"what", signature.what}}.dump();
    }
    return text.empty() ? "{}\n" : text + "\n}\n";
}

std::vector<std::string> recognise(const Signatures& known, const std::string& exercise,
                                   const Signature& signature) {
    std::vector<std::string> same;
    if (signature.where.empty()) return same;
    const Signature* best = nullptr;
    double most = 0, next = 0;
    for (const auto& [name, candidate] : known) {
        if (name.rfind(exercise + '_', 0) != 0) continue;
        const double likeness = similarity(candidate, signature);
        if (best && *best == candidate) {
            same.push_back(name);
        } else if (likeness > most) {
            next = most;
            most = likeness;
            best = &candidate;
            same = {name};
        } else if (likeness > next) {
            next = likeness;
        }
    }
    const bool is_exact = best && *best == signature;
    if (is_exact || (most >= alike_enough && most - next >= clearly_more)) return same;
    return {};
}

Mistake read_mistake(const Course& course, const Chapter& chapter, const std::string& name) {
    std::istringstream in{
        read_file(course.root / "tests/mistakes" / chapter.name / name / "mistake.txt")};
    Mistake mistake{name, "", ""};
    const std::string title = "title: ";
    std::string line;
    while (std::getline(in, line) && !line.empty())
        if (line.rfind(title, 0) == 0) mistake.title = line.substr(title.size());
    while (std::getline(in, line)) {
        if (!mistake.explanation.empty()) mistake.explanation += ' ';
        mistake.explanation += line;
    }
    return mistake;
}

}  // namespace course
