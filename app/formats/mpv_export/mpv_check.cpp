#include "formats/mpv_export/mpv_check.h"

#include "base/text.h"
#include "glsl/compile/check.h"
#include "glsl/text/include.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace {
constexpr std::string_view mark = "//!";
constexpr std::size_t max_binds = 16;
constexpr std::size_t max_textures = 15;  // each has a vertex attribute

constexpr auto directives = std::to_array<std::string_view>(
    {"HOOK", "DESC", "BIND", "SAVE", "COMPONENTS", "WIDTH", "HEIGHT", "TEXTURE", "SIZE", "FORMAT",
     "FILTER", "BORDER", "PARAM", "TYPE", "MINIMUM", "MAXIMUM"});

/// A block of the file.
struct ReadBlock {
    std::vector<std::pair<std::string, std::string>> lines;  // directive, its arguments
    std::string body;

    std::string value(std::string_view directive) const {
        for (const auto& [name, text] : lines)
            if (name == directive)
                return text;
        return {};
    }
    std::vector<std::string> values(std::string_view directive) const {
        std::vector<std::string> all;
        for (const auto& [name, text] : lines)
            if (name == directive)
                all.push_back(text);
        return all;
    }
};

// Everything before the first mark is ignored.
std::vector<ReadBlock> blocks_in(std::string_view text) {
    std::vector<ReadBlock> blocks;
    std::size_t at = text.find(mark);
    while (at != text.npos) {
        ReadBlock block;
        while (text.substr(at).starts_with(mark)) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::string_view line =
                trim(text.substr(at + mark.size(), end - at - mark.size()));
            const std::size_t space = std::min(line.find(' '), line.size());
            block.lines.emplace_back(line.substr(0, space), trim(line.substr(space)));
            at = std::min(end + 1, text.size());
        }
        const std::size_t end = std::min(text.find(mark, at), text.size());
        block.body = text.substr(at, end - at);
        blocks.push_back(std::move(block));
        at = text.find(mark, at);
    }
    return blocks;
}

Result<void> refusal(const std::string& message) {
    return fail({{}, 0, message + " Export the look with --to web or --to portable."});
}

/// Checks block by block.
class Reader {
public:
    Result<void> read(const ReadBlock& block) {
        for (const auto& [name, text] : block.lines)
            if (std::ranges::find(directives, name) == directives.end())
                return refusal(fmt::format("mpv does not know the line '//!{}'.", name));
        if (const std::string name = block.value("PARAM"); !name.empty()) {
            m_parameters += fmt::format("uniform {} {};\n", block.value("TYPE"), name);
            return {};
        }
        if (const std::string name = block.value("TEXTURE"); !name.empty()) {
            m_pictures.insert(name);
            return {};
        }
        return read_hook(block);
    }

private:
    Result<void> read_hook(const ReadBlock& block) {
        const std::string about = block.value("DESC");
        const std::vector<std::string> binds = block.values("BIND");
        std::string declared;
        std::size_t textures = 0;
        for (const std::string& name : binds) {
            if (m_pictures.contains(name)) {
                declared += fmt::format("uniform sampler2D {};\n", name);
                continue;
            }
            if (name != "HOOKED" && !m_saved.contains(name))
                return refusal(
                    fmt::format("The block '{}' reads '{}', which no block saves.", about, name));
            declared += texture_lines(name, textures++);
        }
        if (binds.size() > max_binds || textures > max_textures)
            return refusal(fmt::format("The block '{}' reads {} textures. mpv allows {}.", about,
                                       binds.size(), max_textures));
        if (const std::string name = block.value("SAVE"); !name.empty())
            m_saved.insert(name);
        return compile(about, declared, block.body);
    }

    static std::string texture_lines(const std::string& name, std::size_t i) {
        return fmt::format(
            "uniform sampler2D texture{1};\nuniform vec2 texture_size{1};\nuniform vec2 "
            "pixel_size{1};\nuniform vec2 texture_off{1};\nvec2 texcoord{1} = vec2(0.5);\n"
            "#define {0}_raw texture{1}\n#define {0}_pos texcoord{1}\n#define {0}_size "
            "texture_size{1}\n#define {0}_pt pixel_size{1}\n#define {0}_off texture_off{1}\n",
            name, i);
    }

    Result<void> compile(const std::string& about, const std::string& declared,
                         const std::string& body) const {
        const Stage stage = builtin_stage(fmt::format(
            "#version 440 core\nuniform float random;\nuniform int frame;\nuniform vec2 "
            "input_size;\nuniform vec2 target_size;\nuniform vec2 tex_offset;\nout vec4 "
            "out_color;\n{}{}{}\nvoid main() {{\n    vec4 color = vec4(0.0);\n    color = "
            "hook();\n    out_color = color;\n}}\n",
            m_parameters, declared, body));
        const auto checked = check_program(fullscreen_vertex_stage(), stage);
        if (checked)
            return {};
        std::string message = checked.error().front().message;
        return refusal(fmt::format("The block '{}' does not compile for mpv: {}.", about, message));
    }

    std::string m_parameters;
    std::set<std::string, std::less<>> m_pictures;
    std::set<std::string, std::less<>> m_saved;
};
}  // namespace

Result<void> check_mpv_shader(std::string_view text) {
    const std::vector<ReadBlock> blocks = blocks_in(text);
    if (blocks.empty())
        return refusal("The file has no blocks for mpv.");
    Reader reader;
    for (const ReadBlock& block : blocks)
        if (auto good = reader.read(block); !good)
            return good;
    return {};
}
