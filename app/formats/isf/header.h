#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a person gives a shader for one of its inputs.
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
    // Numbers: one a component; empty where the header does not say them.
    std::vector<double> initial;
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> identity;
    std::vector<double> values;  // of an integer that is chosen from a list
    std::vector<std::string> labels;
    Location declared;
};

/// One draw.
struct IsfPass {
    std::string target;  // the picture that others read it as; "": none
    std::string width;   // expressions; "": that of the output
    std::string height;
    bool is_persistent = false;
    bool is_float = false;
    Location declared;
};

/// A picture that a shader brings along.
struct IsfImport {
    std::string name;
    std::string path;  // from the shader's folder on; of a cube its first face
    Location declared;
    bool is_cube = false;
    std::vector<std::string> faces =
        {};  // of a cube: +x -x +y -y +z -z; empty: `path` has them all
};

/// The JSON that stands before a shader of the Interactive Shader Format, versions 1 and 2.
struct IsfHeader {
    enum class Kind { generator, filter, transition };

    std::string about;
    std::string credit;
    std::vector<IsfInput> inputs;
    std::vector<IsfPass> passes;  // one at least
    std::vector<IsfImport> imports;
    std::size_t code_begin = 0;  // offset of the code; 0 where some stands before the header
    int code_line = 1;           // its line, from 1

    Kind kind() const;
    const IsfInput* find_input(std::string_view name) const;
};

/// Whether the first block comment of a shader's text holds an object. Code may stand before it.
bool has_isf_header(std::string_view text);

/// Reads the header of a shader's text. Errors, several at once, have the file and the line: no
/// JSON, inputs without a name or of a type that there is not, two of one name, more than 64 passes
/// or imports or 1024 inputs, numbers that no shader can have; in a header of one line with the
/// column. Keys that mean nothing are passed over, and so are commas before a bracket that closes.
Result<IsfHeader> read_isf_header(std::string_view text, const std::filesystem::path& file);
