#include "formats/effect/vertex_function.h"

#include "glsl/text/include.h"
#include "glsl/text/interface_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
using Kind = InterfaceStatement::Kind;

/// The names that the vertex shader gets in the fragment shader.
struct VertexNames {
    std::string prefix;  // of the author's names
    std::string position = "afterglow_" + prefix + "position";
    std::string number = "afterglow_" + prefix + "number";
    std::string point_size = "afterglow_" + prefix + "point_size";
    std::string function = "afterglow_" + prefix + "set_inputs";
};

std::string named(const std::string& name, const WordChanges& words) {
    const auto word = words.find(name);
    return word == words.end() ? name : word->second;
}

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
std::vector<PassedValue> passed_values(std::string_view vertex, std::string_view fragment,
                                       const WordChanges& words, const VertexNames& names) {
    const auto outputs = find_interface_statements(vertex);
    std::vector<PassedValue> passed;
    for (const InterfaceStatement& input : find_interface_statements(fragment)) {
        if (input.kind != Kind::input)
            continue;
        for (const Declarator& name : input.declarators) {
            std::string from;
            const bool is_known = std::ranges::find(passed, named(name.name, words),
                                                    &PassedValue::to) != passed.end();
            if (!is_known && find_output(outputs, input, name, from))
                passed.push_back({names.prefix + from, named(name.name, words), input.type,
                                  name.size, input.is_flat});
        }
    }
    return passed;
}

// The names of the vertex shader differ from those of the fragment shader.
WordChanges renamed(std::string_view vertex, const EffectTextRules& rules,
                    const VertexNames& names) {
    WordChanges words = rules.words;
    for (const std::string& name : global_names(vertex))
        if (!rules.declared.contains(name) && !name.starts_with("gl_"))
            words[name] = names.prefix + name;
    words["main"] = names.prefix + "main";
    words["gl_Position"] = names.position;
    words["gl_VertexID"] = names.number;
    words["gl_PointSize"] = names.point_size;
    return words;
}

// No name of the fragment shader starts with it.
std::string free_prefix(std::string_view fragment, std::string prefix) {
    const std::vector<std::string> taken = global_names(fragment);
    while (std::ranges::any_of(taken,
                               [&](const std::string& name) { return name.starts_with(prefix); }))
        prefix.insert(0, "own_");
    return prefix;
}

// Sets the attributes of a corner.
std::string corner_values(const Pass& pass, std::string_view vertex, std::size_t corner,
                          const VertexNames& names) {
    constexpr std::array<std::array<int, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
    if (pass.draw == Draw::fullscreen)
        return fmt::format("    {} = {};\n", names.number, corner);
    std::string text;
    for (const InterfaceStatement& input : find_interface_statements(vertex)) {
        if (input.kind != Kind::input)
            continue;
        const std::string place = fmt::format("{}.0, {}.0", corners[corner][0], corners[corner][1]);
        for (const Declarator& name : input.declarators)
            text +=
                fmt::format("    {}{} = {}({}{});\n", names.prefix, name.name, input.type, place,
                            input.type == "vec4"   ? ", 0.0, 1.0"
                            : input.type == "vec3" ? ", 0.0"
                                                   : "");
    }
    return text;
}

std::string element(const std::string& name, const PassedValue& value) {
    return value.size.empty() ? name : name + "[afterglow_i]";
}

// Sets one input from its values at the corners.
std::string interpolation(const PassedValue& value) {
    const std::string corner = value.from + "_at_";
    const bool is_constant = value.is_flat || value.type.find("int") != std::string::npos ||
                             value.type[0] == 'i' || value.type[0] == 'u';
    const std::string sum =
        is_constant ? element(corner + "2", value)
                    : fmt::format("{0} + afterglow_s * ({1} - {0}) + afterglow_t * ({2} - {0})",
                                  element(corner + "0", value), element(corner + "1", value),
                                  element(corner + "2", value));
    const std::string assignment = fmt::format("{} = {};\n", element(value.to, value), sum);
    return value.size.empty() ? "    " + assignment
                              : fmt::format(
                                    "    for (int afterglow_i = 0; afterglow_i < {}.length(); "
                                    "++afterglow_i)\n        {}",
                                    value.to, assignment);
}

std::string function_text(const Pass& pass, std::string_view vertex,
                          const std::vector<PassedValue>& passed, const VertexNames& names) {
    std::string text = fmt::format("void {}(vec2 afterglow_place) {{\n", names.function);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        text += corner_values(pass, vertex, corner, names);
        text += fmt::format("    {}main();\n", names.prefix);
        text += fmt::format("    vec2 afterglow_corner_{0} = {1}.xy / {1}.w;\n", corner,
                            names.position);
        for (const PassedValue& value : passed)
            text += fmt::format("    {} {}_at_{}{} = {};\n", value.type, value.from, corner,
                                value.size, value.from);
    }
    text +=
        "    vec2 afterglow_a = afterglow_corner_1 - afterglow_corner_0;\n"
        "    vec2 afterglow_b = afterglow_corner_2 - afterglow_corner_0;\n"
        "    vec2 afterglow_d = 2.0 * afterglow_place - 1.0 - afterglow_corner_0;\n"
        "    float afterglow_area = afterglow_a.x * afterglow_b.y - afterglow_a.y * "
        "afterglow_b.x;\n"
        "    float afterglow_s = (afterglow_d.x * afterglow_b.y - afterglow_d.y * afterglow_b.x) / "
        "afterglow_area;\n"
        "    float afterglow_t = (afterglow_a.x * afterglow_d.y - afterglow_a.y * afterglow_d.x) / "
        "afterglow_area;\n";
    for (const PassedValue& value : passed)
        text += interpolation(value);
    return text + "}\n";
}
}  // namespace

bool has_own_vertex(const Pass& pass) {
    return !pass.vertex.text->empty() && *pass.vertex.text != *fullscreen_vertex_stage().text;
}

VertexFunction vertex_function(const Pass& pass, std::string_view fragment,
                               const EffectTextRules& rules, const std::string& prefix) {
    const std::string_view vertex = pass.vertex.text;
    const VertexNames names{free_prefix(fragment, prefix)};
    EffectTextRules own = rules;
    own.input.clear();
    own.output.clear();
    own.words = renamed(vertex, rules, names);
    return {names.function, names.prefix,
            fmt::format("\n// The vertex shader, evaluated at three corners of the target.\n"
                        "vec4 {};\nint {};\nfloat {};\n{}\n{}",
                        names.position, names.number, names.point_size, effect_text(vertex, own),
                        function_text(pass, vertex,
                                      passed_values(vertex, fragment, rules.words, names), names))};
}
