#pragma once

#include "model/look/extent.h"
#include "parity/parsed_chain.h"

#include <epoxy/gl.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What RetroArch's GL driver makes of a preset, by its rules, written without the program's own
/// plan, names and executor.
namespace plain {

/// A picture that a shader may name.
struct Read {
    enum class Of { history, source, output, feedback, lut };

    Of of = Of::source;
    int number = 0;  // history: frames ago

    bool operator==(const Read&) const = default;
};

/// All names of a chain. What is there already stays: aliases come before the format's own names.
struct Names {
    std::map<std::string, Read> textures;
    std::map<std::string, Read> sizes;
};
Names names_of(const ParsedChain& chain);

/// How a texture is read.
struct State {
    bool is_linear = false;
    bool is_linear_between_levels = false;
    Wrap wrap = Wrap::border;
    bool has_levels = false;

    bool operator==(const State&) const = default;
};
/// Of what pass `reader` reads.
State state_of(const ParsedChain& chain, const Read& read, int reader);

/// Whether the last pass is drawn at a size of its own, and copied to the screen by one more.
bool ends_with_copy(const ParsedChain& chain);
/// The pass behind it reads smaller levels of it.
bool has_levels(const ParsedChain& chain, int pass);
/// GL's name of the target's format; the screen is RGBA8.
GLenum format_of(const ParsedChain& chain, int pass);
/// Of every pass, of the copy too.
std::vector<Extent> sizes_of(const ParsedChain& chain, Extent original, Extent viewport);
/// How many former originals are read.
int history_of(const ParsedChain& chain, const Names& names);
bool has_feedback(const ParsedChain& chain, const Names& names, int pass);
/// In force: the preset's, else the first declaration's.
std::optional<double> parameter_of(const ParsedChain& chain, const std::string& name);

}  // namespace plain
