#include "glsl/compile/interface.h"

#include "glsl/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
void merge(Uniform& first, const Uniform& second, Diagnostics& problems) {
    const Location& at = second.declared.front();
    const Location& before = first.declared.front();
    if (first.type_name != second.type_name || first.kind != second.kind)
        problems.push_back(
            {at.file, at.line,
             fmt::format("'{}' is {} here but {} in the vertex shader{}", second.name,
                         with_indefinite_article(second.type_name),
                         with_indefinite_article(first.type_name), location_suffix(before))});
    else if (first.initial && second.initial && first.initial != second.initial)
        problems.push_back({at.file, at.line,
                            fmt::format("'{}' is {} here but {} in the vertex shader{}",
                                        second.name, to_string(*second.initial),
                                        to_string(*first.initial), location_suffix(before))});
    first.declared.push_back(at);
    if (!first.initial)
        first.initial = second.initial;
}
}  // namespace

std::string location_suffix(const Location& at) {
    return at.file.empty() ? "" : fmt::format(" (at {}:{})", at.file.filename().string(), at.line);
}

int first_line_of(std::string_view name, std::string_view text) {
    for (const Token& token : scan(text).all)
        if (token.kind == Token::Kind::word && token.text == name)
            return token.line;
    return 1;
}

std::vector<Uniform> merged_uniforms(const StageInterface& vertex, const StageInterface& fragment,
                                     Diagnostics& problems) {
    std::vector<Uniform> all = vertex.uniforms;
    for (const Uniform& uniform : fragment.uniforms) {
        const auto same = std::ranges::find(all, uniform.name, &Uniform::name);
        if (same == all.end())
            all.push_back(uniform);
        else
            merge(*same, uniform, problems);
    }
    return all;
}

void check_varyings(const StageInterface& vertex, const StageInterface& fragment,
                    const Stage& fragment_stage, Diagnostics& problems) {
    for (const Varying& input : fragment.inputs) {
        const auto output = std::ranges::find(vertex.outputs, input.name, &Varying::name);
        std::string message;
        if (input.has_location || !input.is_used)
            continue;
        if (output == vertex.outputs.end())
            message =
                fmt::format("the vertex shader has no 'out {} {}'", input.type_name, input.name);
        else if (output->type_name != input.type_name)
            message = fmt::format("'{}' is {} here but {} in the vertex shader", input.name,
                                  with_indefinite_article(input.type_name),
                                  with_indefinite_article(output->type_name));
        if (message.empty())
            continue;
        const Location at =
            location_in(fragment_stage, first_line_of(input.name, fragment_stage.text));
        problems.push_back({at.file, at.line, std::move(message)});
    }
}
