#pragma once

#include "formats/slang/files.h"
#include "model/look/look.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Size of one side of a pass's target: base times factor, rounded, at least 1.
struct SlangScale {
    enum class By { source, viewport, absolute, original };

    By by = By::source;
    double factor = 1.0;  // absolute: a whole number of pixels; may be 0 or negative

    bool operator==(const SlangScale&) const = default;
};

/// A pass declared in a .slangp file.
struct SlangPass {
    std::filesystem::path shader;   // resolved path; absolute if the preset's path is absolute
    Location declared;              // line of its shader
    std::optional<bool> is_linear;  // filter for reading; nullopt: not specified
    Wrap wrap = Wrap::border;       // for reading
    int frame_count_mod = 0;        // 0: FrameCount never restarts
    bool is_srgb = false;           // only with a scale
    bool is_float = false;          // only with a scale
    bool reads_mipmaps = false;     // of the previous pass
    std::string alias;              // "": from the shader's #pragma name
    std::optional<std::array<SlangScale, 2>> scale;  // width, height; nullopt: no scale_type
};

/// A picture that shaders read by name (a LUT).
struct SlangTexture {
    std::string name;
    std::filesystem::path file;     // "": the preset has no path, with a warning
    std::optional<bool> is_linear;  // nullopt: not specified
    Wrap wrap = Wrap::border;
    bool is_mipmapped = false;
    Location declared;  // of the path in use, otherwise of `textures`
};

/// The value of a parameter, whether or not a shader declares it.
struct SlangValue {
    double number = 0.0;
    Location declared;
};

/// A .slangp file with everything that it references, except the shader texts.
struct SlangPreset {
    std::vector<SlangPass> passes;       // 1 to 64
    std::vector<SlangTexture> textures;  // at most 64, in the order of UserN
    std::map<std::string, SlangValue> values;
    Diagnostics warnings;
};

/// Reads a preset with RetroArch's tolerance: keys as in settings.h, files as in chain.h. Each
/// other key with a number is a value. Shaders and pictures are only recorded in `files`. Errors,
/// at their lines: errors of the chain, too few or too many passes or textures, a pass without a
/// shader, an unknown scale_type.
Result<SlangPreset> read_slang_preset(const std::filesystem::path& file, SlangFiles& files);

/// The preset for a single .slang file: one pass at the size of the view.
SlangPreset slang_preset_of(const std::filesystem::path& shader);
