#include "formats/isf_export/isf_export.h"

#include "base/text.h"
#include "formats/effect/effect_pictures.h"
#include "formats/effect/shader_functions.h"
#include "formats/isf_export/isf_section.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using Json = nlohmann::ordered_json;

namespace {
std::set<std::string, std::less<>> reserved_names() {
    return {"inputImage",   "source_size",  "texel_middle",      "bordered", "image_read",
            "image_size",   "source_texel", "image_lod",         "image_at", "image_fetch",
            "image_gather", "last_level",   "display_to_linear", "TIME",     "DATE",
            "PASSINDEX",    "RENDERSIZE",   "level_at"};
}

// An expression of the picture's length `whole`, for a mip level. What has the length of the source
// also has room for a source of `source` px. Hosts replace each name only once.
std::string size_text(const Side& side, const char* whole, int source, int level) {
    const std::string base =
        side.by == Side::By::pixels   ? format_number(side.factor)
        : side.by == Side::By::source ? fmt::format("max({}, {})", whole, source)
        : side.factor != 1.0
            ? fmt::format("floor({} * {} + 0.5)", whole, format_number(side.factor))
            : whole;
    return fmt::format("max(1, floor({} / {}))", base, 1 << level);
}

/// Writes the file of one look.
class IsfWriter {
public:
    IsfWriter(const EffectRequest& request, Effect effect)
        : m_request(request), m_effect(std::move(effect)), m_images(m_effect) {
        m_output.losses = m_effect.losses;
    }

    Result<EffectOutput> write() {
        if (const std::string obstacle = m_images.obstacle(); !obstacle.empty())
            return fail(
                {{}, 0, obstacle + ", which ISF can't do. Export it with --to web or --to slang."});
        add_controls();
        if (auto written = write_sections(); !written)
            return fail(written.error());
        if (auto added = add_pictures(); !added)
            return fail(added.error());
        m_output.texts[m_request.name + ".fs"] =
            header() + notice_comment(m_request.look, m_request.notices) + "\n" +
            decoding_function + m_images.functions() + "\n" + m_sections + main_text();
        return std::move(m_output);
    }

private:
    const Look& look() const { return m_effect.look; }

    void add_controls() {
        auto taken = reserved_names();
        for (const Pass& pass : look().passes)
            taken.insert(pass.name);
        EffectNames names(std::move(taken));
        for (IsfControl& control : isf_controls(
                 effect_controls(look(), m_request.values, m_effect.fixed, names), names)) {
            m_order.push_back(control.control.parameter->name);
            m_controls.emplace(m_order.back(), std::move(control));
        }
    }

    Result<void> write_sections() {
        IsfShared shared{look(), m_request.look, m_images, m_controls};
        for (const std::string& name : reserved_names())
            shared.globals.insert(name);
        for (const auto& [parameter, control] : m_controls)
            shared.globals.insert(control.names.begin(), control.names.end());
        for (const IsfImages::Target& target : m_images.targets())
            shared.globals.insert(target.name);
        for (std::size_t i = 0; i < look().passes.size(); ++i) {
            if (look().passes[i].name == m_effect.source_pass) {
                m_entries.emplace_back();  // the source is decoded where it is read
                continue;
            }
            auto uniforms = effect_uniforms(look(), i, m_request.values, m_effect.fixed);
            if (!uniforms)
                return fail(uniforms.error());
            auto section = isf_section(i, *uniforms, shared);
            if (!section)
                return fail(section.error());
            m_sections += section->text;
            m_entries.push_back(std::move(*section));
        }
        return {};
    }

    Result<void> add_pictures() {
        auto pictures =
            effect_pictures(look(), m_request.name + "_pictures", RowOrder::bottom_first, "");
        if (!pictures)
            return fail(pictures.error());
        for (EffectPicture& picture : *pictures) {
            m_imported.emplace_back(picture.name, picture.path);
            m_output.pictures[picture.path] = std::move(picture.file);
        }
        return {};
    }

    Json pass_json(const IsfImages::Target& target) const {
        if (target.name.empty())
            return Json::object();
        const Pass& pass = look().passes[target.pass];
        const Extent source = m_request.source;
        // Mip levels of the source also have room for one of twice the picture's size.
        const bool is_source = pass.name == m_effect.source_pass;
        const char* const width = is_source ? "2 * $WIDTH" : "$WIDTH";
        const char* const height = is_source ? "2 * $HEIGHT" : "$HEIGHT";
        Json json{{"TARGET", target.name},
                  {"WIDTH", size_text(pass.size[0], width, source.width, target.level)},
                  {"HEIGHT", size_text(pass.size[1], height, source.height, target.level)}};
        if (info_of(pass.format).is_float)
            json["FLOAT"] = true;
        const auto reads_before = [&](const Pass& reader) {
            return std::ranges::any_of(reader.inputs, [&](const Input& input) {
                return input.frames_ago > 0 && input.name == pass.name;
            });
        };
        if (std::ranges::any_of(look().passes, reads_before))
            json["PERSISTENT"] = true;
        return json;
    }

    // "*/" would end the comment that holds the header.
    std::string header() const {
        Json json{{"ISFVSN", "2"},
                  {"DESCRIPTION", m_request.look.name + ": " + m_request.look.about},
                  {"CREDIT", m_request.look.author},
                  {"CATEGORIES", {"Stylize"}},
                  {"INPUTS", Json::array()},
                  {"PASSES", Json::array()}};
        json["INPUTS"].push_back({{"NAME", "inputImage"}, {"TYPE", "image"}});
        for (const std::string& name : m_order)
            for (Json& input : isf_inputs(m_controls.at(name)))
                json["INPUTS"].push_back(std::move(input));
        for (const IsfImages::Target& target : m_images.targets())
            json["PASSES"].push_back(pass_json(target));
        for (const auto& [name, path] : m_imported)
            json["IMPORTED"][name] = {{"PATH", path}};
        const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
        return "/*" + replace_all(text, "*/", "*\\/") + "*/\n";
    }

    std::string main_text() const {
        std::string text = "void main() {\n";
        const auto& targets = m_images.targets();
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const IsfImages::Target& target = targets[i];
            const IsfSection& section = m_entries[target.pass];
            text += fmt::format("    {}if (PASSINDEX == {}) {{\n", i == 0 ? "" : "else ", i);
            if (target.level > 0)
                text += fmt::format("        gl_FragColor = {};\n", m_images.level_text(target));
            else
                text += fmt::format("        {}();\n        gl_FragColor = {};\n", section.entry,
                                    section.result);
            text += "    }\n";
        }
        return text + "}\n";
    }

    const EffectRequest& m_request;
    Effect m_effect;
    IsfImages m_images;
    std::map<std::string, IsfControl> m_controls;                 // by name of the parameter
    std::vector<std::string> m_order;                             // of the parameters
    std::vector<IsfSection> m_entries;                            // of each pass
    std::vector<std::pair<std::string, std::string>> m_imported;  // pictures: name, path
    std::string m_sections;
    EffectOutput m_output;
};
}  // namespace

const EffectHost& isf_host() {
    static const EffectHost host{.name = "ISF",
                                 .rows = RowOrder::bottom_first,
                                 .keeps_previous = false,
                                 .has_integers = false};
    return host;
}

Result<EffectOutput> isf_files(const EffectRequest& request) {
    auto effect = effect_of(request.look, request.values, request.size, request.source, isf_host());
    if (!effect)
        return fail(effect.error());
    return IsfWriter(request, std::move(*effect)).write();
}
