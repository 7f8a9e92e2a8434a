#include "formats/web/page_check.h"

#include "glsl/es/es_check.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>

using Json = nlohmann::ordered_json;

namespace {
std::optional<Json> data_of(std::string_view html) {
    constexpr std::string_view start = "id=\"data\">";
    const std::size_t begin = html.find(start);
    const std::size_t end = begin == html.npos ? html.npos : html.find("</script>", begin);
    if (end == html.npos)
        return std::nullopt;
    const std::string_view data = html.substr(begin + start.size(), end - begin - start.size());
    Json json = Json::parse(data, nullptr, false);
    return json.is_object() ? std::optional(std::move(json)) : std::nullopt;
}

std::string shader_fault(const Json& page) {
    for (const Json& pass : page["passes"])
        for (const char* const stage : {"vertex", "fragment"}) {
            const std::string text = page["shaders"].at(pass[stage].get<std::size_t>());
            if (const std::string error = es_error(text, std::string_view(stage) == "fragment");
                !error.empty())
                return fmt::format("The {} shader of pass '{}' does not compile: {}.", stage,
                                   pass["name"].get<std::string>(), error);
        }
    return {};
}

// A list of both, compared by these members.
bool is_same_list(const Json& page, const Json& look, const std::vector<const char*>& members) {
    if (page.size() != look.size())
        return false;
    for (std::size_t i = 0; i < look.size(); ++i)
        for (const char* const member : members)
            if (page[i].value(member, Json()) != look[i].value(member, Json()))
                return false;
    return true;
}
}  // namespace

std::string page_fault(const std::string& html, const PortableFiles& described) {
    const auto page = data_of(html);
    if (!page)
        return "The page has no data.";
    const Json look = Json::parse(described.texts.at(portable_file));
    if (!is_same_list((*page)["passes"], look["passes"], {"name", "repeat", "accumulate", "spot"}))
        return "The page has other passes than the look.";
    if (!is_same_list((*page)["parameters"], look["parameters"], {"name", "value", "min", "max"}))
        return "The page has other values than the look.";
    if (page->value("signal", Json()) != look.value("signal", Json()))
        return "The page has another signal than the look.";
    return shader_fault(*page);
}
