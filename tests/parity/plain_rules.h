#pragma once

#include "model/look/extent.h"
#include "parity/parsed_chain.h"

#include <epoxy/gl.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

/// The rules of RetroArch's GL driver for a preset, implemented without the program's own plan,
/// names and executor.
namespace plain {

/// A texture that a shader may name.
struct Read {
    enum class Of { history, source, output, feedback, lut };

    Of of = Of::source;
    int number = 0;  // history: frames ago

    bool operator==(const Read&) const = default;
};

/// All names of a chain. An existing entry is not replaced: aliases precede built-in names.
struct Names {
    std::map<std::string, Read> textures;
    std::map<std::string, Read> sizes;
};
Names names_of(const ParsedChain& chain);

/// How a texture is sampled.
struct State {
    bool is_linear = false;
    bool is_linear_between_levels = false;
    Wrap wrap = Wrap::border;
    bool has_levels = false;

    bool operator==(const State&) const = default;
};
/// The state of a texture read by pass `reader`.
State state_of(const ParsedChain& chain, const Read& read, int reader);

/// Whether the last pass has its own size and an extra pass copies it to the screen.
bool ends_with_copy(const ParsedChain& chain);
/// Whether the next pass reads mipmaps of this pass.
bool has_levels(const ParsedChain& chain, int pass);
/// The GL format of the pass's target; the screen is RGBA8.
GLenum format_of(const ParsedChain& chain, int pass);
/// The sizes of all passes, the copy included.
std::vector<Extent> sizes_of(const ParsedChain& chain, Extent original, Extent viewport);
/// The number of previous originals that are read.
int history_of(const ParsedChain& chain, const Names& names);
bool has_feedback(const ParsedChain& chain, const Names& names, int pass);
/// The current value: the preset's, else the first declaration's.
std::optional<double> parameter_of(const ParsedChain& chain, const std::string& name);

}  // namespace plain
