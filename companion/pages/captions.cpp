#include <app/value.hpp>
#include <companion/pages/captions.hpp>
#include <companion/system/files.hpp>

namespace companion {

Caption Captions::of(const std::filesystem::path& table, const std::string& study) const {
    Caption caption;
    if (const auto known = studies.find(table.stem().string()); known != studies.end())
        if (const auto found = known->second.find(study); found != known->second.end())
            caption = found->second;
    if (!with_claims) caption.claim.clear();
    caption.axes = axes;
    return caption;
}

Captions read_captions(const std::filesystem::path& file) {
    const app::Value whole = app::Value::parse(read_file(file), file.generic_string())
                                 .with_keys({"what", "axes", "studies"});
    Captions captions;
    const app::Value axes = whole.at("axes"), tables = whole.at("studies");
    for (const std::string& name : axes.keys("names")) captions.axes[name] = axes.at(name).text();
    for (const std::string& table : tables.keys("tables")) {
        const app::Value studies = tables.at(table);
        for (const std::string& study : studies.keys("studies")) {
            const app::Value value = studies.at(study).with_keys({"claim", "shows"});
            Caption& caption = captions.studies[table][study];
            caption.claim = value.at("claim").text();
            if (const auto shows = value.find("shows"))
                caption.shows = shows->word({"cost", "error over cost"});
        }
    }
    return captions;
}

std::string in_words(const Caption& caption, const std::string& name) {
    if (const auto known = caption.axes.find(name); known != caption.axes.end())
        return known->second;
    const auto slash = name.rfind(" / ");
    if (slash == std::string::npos || name.size() - slash > 11) return name;
    return name.substr(0, slash) + ", in " + name.substr(slash + 3);
}

}  // namespace companion
