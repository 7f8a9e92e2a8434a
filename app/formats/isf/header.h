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
    std::string path;  // from the shader's folder on
    Location declared;
};

/// The JSON that stands before a shader of the Interactive Shader Format, versions 1 and 2.
struct IsfHeader {
    enum class Kind { generator, filter, transition };

    std::string about;
    std::string credit;
    std::vector<IsfInput> inputs;
    std::vector<IsfPass> passes;  // one at least
    std::vector<IsfImport> imports;
    std::size_t code_begin = 0;  // offset of what follows the header
    int code_line = 1;           // its line, from 1

    Kind kind() const;
    const IsfInput* find_input(std::string_view name) const;
};

/// Whether a shader's text begins with a comment that holds an object: blanks, `//` comments,
/// `#version` and `#extension` may stand before it.
bool has_isf_header(std::string_view text);

/// Reads the header of a shader's text. Errors, several at once, have the file and the line: no
/// JSON, inputs without a name or of a type that there is not, two of one name, more than 64 passes
/// or imports or 1024 inputs, numbers that no shader can have. Keys that mean nothing are passed
/// over.
Result<IsfHeader> read_isf_header(std::string_view text, const std::filesystem::path& file);
