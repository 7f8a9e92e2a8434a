#include "formats/web/web_page.h"

#include "base/text.h"
#include "formats/web/page_members.h"
#include "formats/web/page_parts.h"
#include "formats/web/web_media.h"
#include "model/picture/source_spec.h"
#include "signals/patterns/patterns.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

using Json = nlohmann::ordered_json;

namespace {
constexpr std::string_view pattern_prefix = "pattern:";

std::string html_text(std::string_view text) {
    std::string escaped;
    for (const char letter : text)
        switch (letter) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += letter;
        }
    return escaped;
}

// JSON that can't end a script element.
std::string script_json(const Json& json) {
    return replace_all(json.dump(-1, ' ', false, Json::error_handler_t::replace), "<", "\\u003c");
}

// The files that a page does not read: a picture of a moving test picture, and the file of a signal
// that is drawn from its paths.
std::set<std::string> unread_files(Json& json) {
    std::set<std::string> unread;
    if (json.contains("source") && json["source"].contains("generated")) {
        Json& source = json["source"];
        const auto generated = parse_source(source["generated"].get<std::string>());
        if (generated && generated->is_pattern() &&
            is_moving_pattern(generated->picture.substr(pattern_prefix.size()))) {
            unread.insert(parse_source(source["content"].get<std::string>())->picture);
            source["content"] = source["generated"];
        }
    }
    if (json.contains("signal") && json["signal"].contains("paths"))
        if (const Json& settings = json["signal"]["settings"]; settings.contains("file"))
            unread.insert(settings["file"].get<std::string>());
    return unread;
}

/// The media of a page as JSON values, by path.
using MediaTexts = std::map<std::string, std::string>;

// A scene is in a folder with the files of its items.
bool is_unread(const std::string& path, const std::set<std::string>& unread) {
    return std::ranges::any_of(unread, [&](const std::string& file) {
        const std::string folder = std::filesystem::path(file).parent_path().string() + "/";
        return path == file || (folder != "media/" && path.starts_with(folder));
    });
}

Result<MediaTexts> media_of(const PortableFiles& described, const std::set<std::string>& unread) {
    MediaTexts texts;
    const auto add = [&](const std::string& path, const auto& content) -> Result<void> {
        if (is_unread(path, unread))
            return {};
        auto text = web_media(content);
        if (!text)
            return fail(text.error());
        texts.emplace(path, std::move(*text));
        return {};
    };
    for (const auto& [path, picture] : described.generated)
        if (auto added = add(path, picture); !added)
            return fail(added.error());
    for (const auto& [path, file] : described.media)
        if (auto added = add(path, file); !added)
            return fail(added.error());
    return texts;
}

std::uintmax_t bytes_of(const MediaTexts& media) {
    std::uintmax_t bytes = 0;
    for (const auto& [path, text] : media)
        bytes += text.size();
    return bytes;
}

bool has_word(std::string_view text, std::string_view word) {
    const auto is_letter = [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
    };
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end])))
            return true;
    }
    return false;
}

// Leaves out members that the page assumes, see readDescription() in app/web/look/description.js.
void leave_out(const Json& usual, Json& json) {
    for (const auto& [key, value] : usual.items())
        if (json.contains(key) && json[key] == value)
            json.erase(key);
}

// Blanks of expressions have no meaning.
void remove_blanks(Json& json) {
    if (json.is_string())
        json = replace_all(json.get<std::string>(), " ", "");
}

void shorten_target(Json& json) {
    for (const char* const side : {"width", "height"})
        if (json[side].contains("expression"))
            remove_blanks(json[side]["expression"]);
    for (const char* const key : {"one_channel", "half_floats"})
        if (json.contains(key))
            remove_blanks(json[key]);
    leave_out({{"format", "rgba16f"}, {"encoding", "linear"}, {"rows", "bottom-first"}}, json);
}

// Replaces a pass's shaders by their numbers, and removes uniforms that they do not read.
void use_shaders(const EsShaders& shaders, std::size_t pass, Json& json) {
    const auto [vertex, fragment] = shaders.passes[pass];
    json["vertex"] = vertex;
    json["fragment"] = fragment;
    for (const char* const key : {"inputs", "built_ins", "parameters"}) {
        Json read = Json::array();
        for (const Json& entry : json[key]) {
            // "block.member" in programs that were translated
            const std::string uniform = entry["uniform"];
            const std::string name = uniform.substr(0, uniform.find('.'));
            if (has_word(shaders.texts[vertex], name) || has_word(shaders.texts[fragment], name))
                read.push_back(entry);
        }
        json[key] = std::move(read);
    }
    Json bindings = Json::object();
    for (const Json& binding : json["parameters"])
        bindings[binding["uniform"]] = binding["parameter"];
    json["parameters"] = std::move(bindings);
    json.erase("onto");  // an optimisation
    const Json usual{{"draw", "fullscreen"},         {"blend", "replace"},
                     {"inputs", Json::array()},      {"built_ins", Json::array()},
                     {"parameters", Json::object()}, {"set", Json::object()}};
    leave_out(usual, json);
    if (json.contains("inputs"))
        for (Json& input : json["inputs"])
            leave_out({{"wrap", "edge"}, {"filter", "linear"}, {"mipmap", false}}, input);
    shorten_target(json["target"]);
}

// A page can change the constant: it compiles the shaders again.
void use_constant(const Look& look, const EsConstant& constant, Json& json) {
    const NumberType& type = look.parameters[static_cast<std::size_t>(constant.id)].type;
    json.erase("constant");
    json["constant_id"] = constant.id;
    json["constant_type"] = glsl_name(type);
}

void shorten_parameter(Json& json) {
    leave_out({{"step", 0.0},
               {"scale", "linear"},
               {"unit", ""},
               {"help", ""},
               {"items", Json::array()},
               {"group", ""},
               {"passes", json["passes"]},
               {"label", label_from_name(json["name"].get<std::string>())}},
              json);
}

// Replaces the settings of generators by their numbers in a list without duplicates.
Json shared_settings(Json& generators) {
    Json list = Json::array();
    for (Json& generator : generators)
        for (Json& setting : generator["settings"]) {
            shorten_parameter(setting);
            const auto place = std::ranges::find(list, setting) - list.begin();
            if (place == static_cast<std::ptrdiff_t>(list.size()))
                list.push_back(setting);
            setting = place;
        }
    return list;
}

bool reads_pictures(const Json& json) {
    const auto is_picture = [](const Json& parameter) { return parameter["type"] == "image"; };
    return json.contains("source") || !json["images"].empty() ||
           std::ranges::any_of(json["parameters"], is_picture);
}

// Fills the places of the template in one pass, so that no text is taken for a place.
std::string filled(std::string_view page, const std::map<std::string, std::string>& texts) {
    std::string result;
    for (;;) {
        const std::size_t begin = page.find("{{");
        const std::size_t end = begin == page.npos ? page.npos : page.find("}}", begin);
        if (end == page.npos)
            return result.append(page);
        result.append(page.substr(0, begin));
        if (const auto found = texts.find(std::string(page.substr(begin + 2, end - begin - 2)));
            found != texts.end())
            result.append(found->second);
        page.remove_prefix(end + 2);
    }
}
}  // namespace

Result<WebPage> web_page(const Look& look, const PortableFiles& described, const EsShaders& shaders,
                         const std::string& media_folder, std::uintmax_t max_embedded) {
    Json json = Json::parse(described.texts.at(portable_file));
    for (std::size_t i = 0; i < shaders.passes.size(); ++i)
        use_shaders(shaders, i, json["passes"][i]);
    json["shaders"] = shaders.texts;
    add_page_members(look, json);
    for (const EsConstant& constant : shaders.constants)
        use_constant(look, constant, json["parameters"][static_cast<std::size_t>(constant.id)]);
    for (Json& parameter : json["parameters"])
        shorten_parameter(parameter);
    if (json.contains("generators"))
        json["settings"] = shared_settings(json["generators"]);
    const auto media = media_of(described, unread_files(json));
    if (!media)
        return fail(media.error());
    json["media"] = Json::object();
    const bool is_embedded = bytes_of(*media) <= max_embedded;
    WebPage page;
    std::string links;
    for (const auto& [path, text] : *media) {
        if (is_embedded) {
            json["media"][path] = Json::parse(text);
            continue;
        }
        const std::string script =
            fmt::format("{}/{}.js", media_folder, replace_all(path.substr(6), "/", "-"));
        page.scripts[script] =
            fmt::format("(window.afterglowMedia = window.afterglowMedia || {{}})[{}] = {};\n",
                        Json(path).dump(), text);
        links += fmt::format("<script src=\"{}\"></script>\n", html_text(script));
    }
    const PageParts parts = page_parts();
    page.html = filled(
        parts.page,
        {{"TITLE", html_text(json["name"].get<std::string>())},
         {"ABOUT", html_text(json["about"].get<std::string>())},
         {"STYLE", std::string(parts.style)},
         {"MEDIA", links},
         {"DATA", script_json(json)},
         {"SCRIPT", std::string(reads_pictures(json) ? parts.picture_script : parts.script)}});
    return page;
}
