#include "formats/effect/vertex_function.h"

#include "glsl/text/include.h"
#include "glsl/text/interface_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
using Kind = InterfaceStatement::Kind;

constexpr const char* prefix = "vertex_";

/// A value that the vertex shader passes to the fragment shader.
struct PassedValue {
    std::string from;  // the vertex shader's variable
    std::string to;    // the fragment shader's variable
    std::string type;
    std::string size;  // "[3]" for an array
    bool is_flat = false;
};

const InterfaceStatement* find_output(const std::vector<InterfaceStatement>& vertex,
                                      const InterfaceStatement& input, const Declarator& name,
                                      std::string& from) {
    for (const InterfaceStatement& output : vertex)
        for (const Declarator& one : output.declarators) {
            const bool is_same = input.location >= 0 && output.location >= 0
                                     ? input.location == output.location
                                     : one.name == name.name;
            if (output.kind == Kind::output && is_same) {
                from = one.name;
                return &output;
            }
        }
    return nullptr;
}

// Each name once, because branches of an #if can declare the same one.
std::vector<PassedValue> passed_values(std::string_view vertex, std::string_view fragment) {
    const auto outputs = find_interface_statements(vertex);
    std::vector<PassedValue> passed;
    for (const InterfaceStatement& input : find_interface_statements(fragment)) {
        if (input.kind != Kind::input)
            continue;
        for (const Declarator& name : input.declarators) {
            std::string from;
            const bool is_known =
                std::ranges::find(passed, name.name, &PassedValue::to) != passed.end();
            if (!is_known && find_output(outputs, input, name, from))
                passed.push_back({prefix + from, name.name, input.type, name.size, input.is_flat});
        }
    }
    return passed;
}

// The names of the vertex shader that differ from those of the fragment shader.
WordChanges renamed(std::string_view vertex, const EffectTextRules& rules) {
    WordChanges words{{"main", std::string(prefix) + "main"},
                      {"gl_Position", std::string(prefix) + "position_in_clip_space"},
                      {"gl_VertexID", std::string(prefix) + "number"},
                      {"gl_PointSize", std::string(prefix) + "size"}};
    for (const std::string& name : global_names(vertex))
        if (!rules.declared.contains(name) && !name.starts_with("gl_"))
            words.emplace(name, prefix + name);
    return words;
}

// Sets the attributes of a corner.
std::string corner_values(const Pass& pass, std::string_view vertex, std::size_t corner) {
    constexpr std::array<std::array<int, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
    if (pass.draw == Draw::fullscreen)
        return fmt::format("    {}number = {};\n", prefix, corner);
    std::string text;
    for (const InterfaceStatement& input : find_interface_statements(vertex)) {
        if (input.kind != Kind::input)
            continue;
        const std::string place = fmt::format("{}.0, {}.0", corners[corner][0], corners[corner][1]);
        for (const Declarator& name : input.declarators)
            text += fmt::format("    {}{} = {}({}{});\n", prefix, name.name, input.type, place,
                                input.type == "vec4"   ? ", 0.0, 1.0"
                                : input.type == "vec3" ? ", 0.0"
                                                       : "");
    }
    return text;
}

std::string element(const std::string& name, const PassedValue& value) {
    return value.size.empty() ? name : name + "[i]";
}

// Sets one input from its values at the corners.
std::string interpolation(const PassedValue& value) {
    const std::string corner = value.from + "_at_";
    const bool is_constant = value.is_flat || value.type.find("int") != std::string::npos ||
                             value.type[0] == 'i' || value.type[0] == 'u';
    const std::string sum =
        is_constant
            ? element(corner + "2", value)
            : fmt::format("{0} + s * ({1} - {0}) + t * ({2} - {0})", element(corner + "0", value),
                          element(corner + "1", value), element(corner + "2", value));
    const std::string assignment = fmt::format("{} = {};\n", element(value.to, value), sum);
    return value.size.empty() ? "    " + assignment
                              : fmt::format("    for (int i = 0; i < {}.length(); ++i)\n        {}",
                                            value.to, assignment);
}

std::string function_text(const Pass& pass, std::string_view vertex,
                          const std::vector<PassedValue>& passed) {
    std::string text = fmt::format("void {}(vec2 place) {{\n", vertex_function_name);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        text += corner_values(pass, vertex, corner);
        text += fmt::format("    {}main();\n", prefix);
        text += fmt::format(
            "    vec2 corner_{0} = {1}position_in_clip_space.xy / {1}position_in_clip_space.w;\n",
            corner, prefix);
        for (const PassedValue& value : passed)
            text += fmt::format("    {} {}_at_{}{} = {};\n", value.type, value.from, corner,
                                value.size, value.from);
    }
    text +=
        "    vec2 a = corner_1 - corner_0;\n"
        "    vec2 b = corner_2 - corner_0;\n"
        "    vec2 d = 2.0 * place - 1.0 - corner_0;\n"
        "    float s = (d.x * b.y - d.y * b.x) / (a.x * b.y - a.y * b.x);\n"
        "    float t = (a.x * d.y - a.y * d.x) / (a.x * b.y - a.y * b.x);\n";
    for (const PassedValue& value : passed)
        text += interpolation(value);
    return text + "}\n";
}
}  // namespace

bool has_own_vertex(const Pass& pass) {
    return !pass.vertex.text->empty() && *pass.vertex.text != *fullscreen_vertex_stage().text;
}

std::string vertex_function(const Pass& pass, std::string_view fragment,
                            const EffectTextRules& rules) {
    const std::string_view vertex = pass.vertex.text;
    EffectTextRules own = rules;
    own.input.clear();
    own.output.clear();
    own.words = renamed(vertex, rules);
    return fmt::format(
        "\n// The vertex shader, evaluated at three corners of the target.\n"
        "vec4 {0}position_in_clip_space;\nint {0}number;\nfloat {0}size;\n{1}\n{2}",
        prefix, effect_text(vertex, own),
        function_text(pass, vertex, passed_values(vertex, fragment)));
}
