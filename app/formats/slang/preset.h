#pragma once

#include "formats/slang/files.h"
#include "model/look/look.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// One side of what a pass draws into: its size is the base times the factor, rounded, at least 1.
struct SlangScale {
    enum class By { source, viewport, absolute, original };

    By by = By::source;
    double factor = 1.0;  // absolute: a whole number of pixels; may be 0 or below

    bool operator==(const SlangScale&) const = default;
};

/// A pass as a .slangp file declares it.
struct SlangPass {
    std::filesystem::path shader;   // as it is found, absolute where the preset's path is
    Location declared;              // of its shader's line
    std::optional<bool> is_linear;  // how this pass reads; none: not said
    Wrap wrap = Wrap::border;       // how this pass reads
    int frame_count_mod = 0;        // 0: FrameCount never starts again
    bool is_srgb = false;           // counts only with a scale
    bool is_float = false;          // counts only with a scale
    bool reads_mipmaps = false;     // of the pass before it
    std::string alias;              // "": what the shader's #pragma name says
    std::optional<std::array<SlangScale, 2>> scale;  // width, height; none: no scale_type is said
};

/// A picture that shaders read by its name (a LUT).
struct SlangTexture {
    std::string name;
    std::filesystem::path file;     // "": the preset gives no path, which is a warning
    std::optional<bool> is_linear;  // none: not said
    Wrap wrap = Wrap::border;
    bool is_mipmapped = false;
    Location declared;  // of the path that counts; of `textures` where there is none
};

/// What a parameter is set to, whether a shader has one of this name or not.
struct SlangValue {
    double number = 0.0;
    Location declared;
};

/// A .slangp file with all that it refers to, but for the shaders' texts.
struct SlangPreset {
    std::vector<SlangPass> passes;       // 1 to 64
    std::vector<SlangTexture> textures;  // at most 64, in the order that UserN counts
    std::map<std::string, SlangValue> values;
    Diagnostics warnings;
};

/// Reads a preset as RetroArch does, and as forgivingly: keys of settings.h, files of chain.h.
/// Every key that is not of a pass or texture and has a number is a value. Shaders and pictures
/// are not looked for, only noted in `files`. Errors, at their lines: what the chain says, a count
/// of passes or textures out of its limits, a pass without a shader, an unknown scale_type.
Result<SlangPreset> read_slang_preset(const std::filesystem::path& file, SlangFiles& files);

/// What opening a .slang file alone means: one pass, drawn at the size of the view.
SlangPreset slang_preset_of(const std::filesystem::path& shader);
