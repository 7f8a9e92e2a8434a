#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What is declared with a name and a type: a variable, a parameter or a field.
struct TypedName {
    std::string name;
    std::string type;  // as written, without qualifiers and array sizes: "vec3", "Ray"
};

struct FunctionName {
    std::string name;
    std::string type;                     // of the result
    std::vector<std::string> parameters;  // their types
};

/// A struct, or a block with an instance name. The type of such an instance is the block's name.
struct StructName {
    std::string name;
    std::vector<TypedName> fields;
};

/// The names that code can use at one place of a shader.
struct ShaderNames {
    std::vector<TypedName> variables;  // also uniforms, parameters, and fields of unnamed instances
    std::vector<FunctionName> functions;
    std::vector<StructName> structs;
    std::vector<std::string> macros;

    /// The last of that name, because inner declarations hide outer ones; null if there is none.
    const TypedName* find_variable(std::string_view name) const;
    const FunctionName* find_function(std::string_view name) const;
    const StructName* find_struct(std::string_view name) const;
};

/// The names declared up to the end of a line (from 1) and visible in a part of that line, found by
/// scanning tokens. Works for shaders with errors. Macros are not expanded, and every branch of an
/// #if counts. A loop's variable stays visible until the enclosing block ends.
ShaderNames names_at(std::string_view text, int line);

/// Whether a word is a type of GLSL itself, such as "vec3" or "sampler2D".
bool is_glsl_type(std::string_view word);
/// Types of GLSL that shaders of this program use.
const std::vector<std::string>& common_glsl_types();
/// Keywords of GLSL 4.10 with at least four letters, without types.
const std::vector<std::string>& glsl_keywords();
