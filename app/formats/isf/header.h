#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// An input of a shader, set by the user.
struct IsfInput {
    enum class Type {
        floating,
        boolean,
        integer,
        event,
        point,
        color,
        image,
        audio,
        audio_fft,
        cube
    };

    Type type = Type::floating;
    std::string name;
    std::string label;
    // Numbers: one per component; empty if not in the header.
    std::vector<double> initial;
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> identity;
    std::vector<double> values;  // for an integer chosen from a list
    std::vector<std::string> labels;
    Location declared;
};

/// One draw.
struct IsfPass {
    std::string target;  // the name by which other passes read it; "": none
    std::string width;   // expressions; "": the output's size
    std::string height;
    bool is_persistent = false;
    bool is_float = false;
    Location declared;
};

/// A picture that belongs to a shader.
struct IsfImport {
    std::string name;
    std::string path;  // relative to the shader's folder; for a cube, its first face
    Location declared;
    bool is_cube = false;
    std::vector<std::string> faces = {};  // for a cube: +x -x +y -y +z -z; empty: all in `path`
};

/// The JSON header of a shader in the Interactive Shader Format, versions 1 and 2.
struct IsfHeader {
    enum class Kind { generator, filter, transition };

    std::string about;
    std::string credit;
    std::vector<IsfInput> inputs;
    std::vector<IsfPass> passes;  // at least one
    std::vector<IsfImport> imports;
    std::size_t code_begin = 0;  // offset of the code; 0 if code precedes the header
    int code_line = 1;           // line of the code, from 1

    Kind kind() const;
    const IsfInput* find_input(std::string_view name) const;
};

/// Whether the first block comment of a shader's text contains a JSON object. Code may precede it.
bool has_isf_header(std::string_view text);

/// Reads the header of a shader's text. Errors, several at once, have the file and the line; in a
/// one-line header also the column. Errors: invalid JSON; inputs without a name or with an unknown
/// type; duplicate names; more than 64 passes or imports or 1024 inputs; numbers that no shader can
/// use. Ignores unknown keys and commas before a closing bracket.
Result<IsfHeader> read_isf_header(std::string_view text, const std::filesystem::path& file);
