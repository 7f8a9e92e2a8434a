#include "glsl/compile/type_names.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace {
constexpr std::string_view vector_of = "-component vector of ";
constexpr std::string_view matrix_of = " matrix of ";
constexpr std::string_view array_of = "array of ";

// What glslang writes before the type itself, besides layout(...).
constexpr auto qualifiers = std::to_array<std::string_view>({
    "const",
    "(read",
    "only)",
    "temp",
    "global",
    "uniform",
    "buffer",
    "in",
    "out",
    "inout",
    "smooth",
    "flat",
    "centroid",
    "sample",
    "noperspective",
    "patch",
    "invariant",
    "precise",
    "coherent",
    "volatile",
    "restrict",
    "readonly",
    "writeonly",
    "highp",
    "mediump",
    "lowp",
    "shared",
    "nonuniform",
    "specialization-constant",
});

// "vec" of float, "ivec" of int; empty for a scalar without vectors.
std::string prefix_of(std::string_view scalar) {
    constexpr auto prefixes = std::to_array<std::pair<std::string_view, std::string_view>>({
        {"float", ""},
        {"int", "i"},
        {"uint", "u"},
        {"bool", "b"},
        {"double", "d"},
    });
    const auto found = std::ranges::find(prefixes, scalar, &decltype(prefixes)::value_type::first);
    return found == prefixes.end() ? std::string(scalar) + ' ' : std::string(found->second);
}

std::string_view first_word(std::string_view text) {
    return text.substr(0, text.find(' '));
}

std::string_view without_layout(std::string_view text) {
    const std::size_t close = text.find(')');
    return text.starts_with("layout(") && close != std::string_view::npos
               ? trim(text.substr(close + 1))
               : text;
}

std::string_view without_qualifiers(std::string_view text) {
    text = without_layout(trim(text));
    while (std::ranges::find(qualifiers, first_word(text)) != qualifiers.end() &&
           first_word(text).size() < text.size())
        text = trim(text.substr(first_word(text).size()));
    return text;
}

// Removes "3-element array of " and the like; adds "[3]".
std::string_view without_arrays(std::string_view text, std::string& sizes) {
    const auto begins = [&text] {
        const std::string_view word = first_word(text);
        return word.ends_with("-element") || word == "unsized" || word == "runtime-sized" ||
               word == "implicitly-sized" || word == "array";
    };
    while (begins()) {
        const std::size_t at = text.find(array_of);
        if (at == std::string_view::npos)
            return text;
        const std::string_view count = text.substr(0, text.find('-'));
        sizes += parse_integer(count) ? fmt::format("[{}]", count) : "[]";
        text = without_qualifiers(text.substr(at + array_of.size()));
    }
    return text;
}

std::string_view without_precision(std::string_view text) {
    return without_qualifiers(text);
}

std::string single_type_name(std::string_view text) {
    if (text.starts_with("structure{"))
        return "struct";
    if (text.starts_with("block{"))
        return "block";
    if (const std::size_t at = text.find(vector_of); at != std::string_view::npos)
        return prefix_of(without_precision(text.substr(at + vector_of.size()))) + "vec" +
               std::string(text.substr(0, at));
    if (const std::size_t at = text.find(matrix_of); at != std::string_view::npos) {
        const std::vector<std::string_view> sides = split(text.substr(0, at), 'X');
        const std::string name =
            prefix_of(without_precision(text.substr(at + matrix_of.size()))) + "mat";
        if (sides.size() != 2)
            return name;
        return sides[0] == sides[1] ? fmt::format("{}{}", name, sides[0])
                                    : fmt::format("{}{}x{}", name, sides[0], sides[1]);
    }
    return std::string(text);
}
}  // namespace

std::string glsl_type_name(std::string_view description) {
    std::string sizes;
    const std::string_view type = without_arrays(without_qualifiers(description), sizes);
    return single_type_name(type) + sizes;
}

std::vector<std::string> described_fields(std::string_view description) {
    const std::size_t open = description.find('{');
    const std::size_t close = description.rfind('}');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        return {};
    std::vector<std::string> fields;
    int depth = 0;
    std::size_t begin = open + 1;
    for (std::size_t i = begin; i <= close; ++i) {
        const char c = description[i];
        if ((c == ',' && depth == 0) || i == close) {
            const std::string_view field = trim(description.substr(begin, i - begin));
            fields.emplace_back(field.substr(field.rfind(' ') + 1));
            begin = i + 1;
        }
        depth += (c == '{' || c == '(') ? 1 : (c == '}' || c == ')') ? -1 : 0;
    }
    return fields;
}
