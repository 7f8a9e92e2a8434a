#include "formats/effect/struct_values.h"

#include "formats/effect/effect_text.h"
#include "glsl/text/interface_statements.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
bool declares(std::string_view text, const std::string& name) {
    const std::vector<std::string> names = global_names(text);
    return std::ranges::find(names, name) != names.end();
}
}  // namespace

std::string struct_settings(const Pass& pass, const std::vector<StructValue>& structs,
                            const WordChanges& words, const std::string& vertex_prefix) {
    std::string text;
    for (const StructValue& of : structs) {
        if (declares(pass.fragment.text, of.name))
            text += fmt::format("    {} = {}({});\n", renamed_word(words, of.name),
                                renamed_word(words, of.type), of.members);
        if (!vertex_prefix.empty() && declares(pass.vertex.text, of.name))
            text += fmt::format("    {0}{1} = {0}{2}({3});\n", vertex_prefix, of.name, of.type,
                                of.members);
    }
    return text;
}

ShaderEnds ends_of_shader(const std::string& fragment, const WordChanges& words) {
    ShaderEnds ends;
    for (const InterfaceStatement& statement : find_interface_statements(fragment)) {
        if (statement.declarators.empty())
            continue;
        std::string name = renamed_word(words, statement.declarators.front().name);
        if (statement.kind == InterfaceStatement::Kind::output)
            ends.output = name;
        if (statement.kind == InterfaceStatement::Kind::input)
            ends.input = name;
    }
    return ends;
}
