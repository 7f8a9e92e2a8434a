#include "formats/shadertoy/shadertoy_directives.h"

#include "base/text.h"
#include "glsl/compile/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view channel_mark = "#iChannel";
constexpr std::string_view uniform_mark = "#iUniform";

bool is_shader_code(const fs::path& file) {
    const std::string ending = to_lower(file.extension().string());
    return ending == ".glsl" || ending == ".frag" || ending == ".fs" || ending == ".fsh";
}

std::string between_quotes(std::string_view text) {
    const std::size_t open = text.find('"');
    const std::size_t close = open == std::string_view::npos ? open : text.find('"', open + 1);
    return close == std::string_view::npos ? std::string()
                                           : std::string(text.substr(open + 1, close - open - 1));
}

// Removes "file://" and decodes %20.
std::string path_of(std::string_view written) {
    constexpr std::string_view scheme = "file://";
    if (written.starts_with(scheme))
        written.remove_prefix(scheme.size());
    return replace_all(std::string(written), "%20", " ");
}

class DirectiveReader {
public:
    DirectiveReader(ShadertoyPass& pass, const std::function<int(const fs::path&)>& buffer_of,
                    Diagnostics& warnings)
        : m_pass(pass), m_buffer_of(buffer_of), m_warnings(warnings) {}

    void read() {
        std::string text;
        std::size_t number = 0;
        for (const std::string_view line : split(*m_pass.code.text, '\n')) {
            m_at = location_in(m_pass.code, static_cast<int>(++number));
            text += (number > 1 ? "\n" : "") + translated(line);
        }
        if (m_is_used)
            m_pass.code.text = std::move(text);
    }

private:
    std::string translated(std::string_view line) {
        const std::string_view words = trim(line);
        if (words.starts_with(channel_mark)) {
            m_is_used = m_pass.has_explicit_inputs = true;
            read_channel(words.substr(channel_mark.size()));
            return {};
        }
        if (words.starts_with(uniform_mark)) {
            m_is_used = true;
            return uniform_of(words.substr(uniform_mark.size()));
        }
        if (words.starts_with("#iKeyboard") || words.starts_with("#StrictCompatibility")) {
            m_is_used = true;
            return {};
        }
        return std::string(line);
    }

    void warn(std::string message) {
        m_warnings.push_back({m_at.file, m_at.line, std::move(message), Severity::warning});
    }

    ShadertoyInput& channel(int number) {
        const auto known = std::ranges::find(m_pass.inputs, number, &ShadertoyInput::channel);
        if (known != m_pass.inputs.end())
            return *known;
        ShadertoyInput made;
        made.channel = number;
        made.declared = m_at;
        return m_pass.inputs.emplace_back(std::move(made));
    }

    // `rest` follows "#iChannel": "0 "file://a.png"", "0::WrapMode "Repeat"".
    void read_channel(std::string_view rest) {
        if (rest.empty() || rest[0] < '0' || rest[0] >= '0' + shadertoy_channels)
            return warn("expected a channel from #iChannel0 to #iChannel3");
        ShadertoyInput& input = channel(rest[0] - '0');
        rest.remove_prefix(1);
        const std::string value = between_quotes(rest);
        if (!rest.starts_with("::"))
            return wire(input, value);
        const std::string_view setting = rest.substr(2, rest.find_first_of(" \t\"", 2) - 2);
        if (setting == "MinFilter" || setting == "MagFilter") {
            input.sampler.filter = value == "Nearest" ? Filter::nearest : Filter::linear;
            input.sampler.mipmap = value.find("MipMap") != std::string::npos;
        } else if (setting == "WrapMode") {
            input.sampler.wrap = value == "Repeat"   ? Wrap::repeat
                                 : value == "Mirror" ? Wrap::mirror
                                                     : Wrap::edge;
        } else if (setting == "Type") {
            input.kind = value == "CubeMap" ? ShadertoyKind::cubemap : input.kind;
        } else {
            warn(
                fmt::format("unknown channel setting '{}' is ignored; use MinFilter, MagFilter, "
                            "WrapMode or Type",
                            setting));
        }
    }

    void wire(ShadertoyInput& input, const std::string& value) {
        const bool is_cube = input.kind == ShadertoyKind::cubemap;
        if (value == "self") {
            input.kind = ShadertoyKind::buffer;
            input.buffer = m_buffer_of(m_pass.code.file);
        } else if (value == "keyboard") {
            input.kind = ShadertoyKind::keyboard;
        } else if (value.starts_with("http://") || value.starts_with("https://")) {
            input.kind = ShadertoyKind::texture;
            warn(fmt::format(
                "Afterglow doesn't download '{}'. Save it next to the shader and use its file name "
                "here. A built-in picture replaces it.",
                value));
        } else if (const std::string path = path_of(value); is_shader_code(path)) {
            input.kind = ShadertoyKind::buffer;
            input.buffer = m_buffer_of(m_pass.code.file.parent_path() / path);
        } else {
            input.kind = is_cube ? ShadertoyKind::cubemap : ShadertoyKind::texture;
            input.asset = path;
            input.is_file = true;
        }
    }

    // Parses "float gain = 0.5 in { 0.0, 1.0 } step 0.1".
    std::string uniform_of(std::string_view rest) {
        const std::string whole(trim(rest));
        const std::size_t open = whole.find('{');
        const std::size_t close = whole.find('}');
        const std::size_t in = open == std::string::npos ? open : whole.rfind(" in", open);
        const std::size_t step = whole.find(" step ");
        std::string declaration = whole.substr(0, std::min(in, step));
        while (declaration.ends_with(' ') || declaration.ends_with(';'))
            declaration.pop_back();
        std::string hints;
        if (in != std::string::npos && close != std::string::npos && close > open) {
            hints = whole.substr(open + 1, close - open - 1);
            std::ranges::replace(hints, ',', ' ');
            hints = "  // @range " + hints;
            if (step != std::string::npos)
                hints += ' ' + whole.substr(step + 6);
        }
        if (declaration.starts_with("color3")) {
            declaration = replace_all(declaration, "color3", "vec3");
            hints += hints.empty() ? "  // @color" : " @color";
        }
        return "uniform " + declaration + ";" + hints;
    }

    ShadertoyPass& m_pass;
    const std::function<int(const fs::path&)>& m_buffer_of;
    Diagnostics& m_warnings;
    Location m_at;
    bool m_is_used = false;
};
}  // namespace

void read_shadertoy_directives(ShadertoyPass& pass,
                               const std::function<int(const fs::path&)>& buffer_of,
                               Diagnostics& warnings) {
    DirectiveReader(pass, buffer_of, warnings).read();
}
