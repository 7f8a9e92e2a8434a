#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// A shader file of an effect.
struct EffectFile {
    std::string name;  // relative to the effect's folder, with '/' as separator
    std::string text;
    bool is_once = false;                    // further includes of it are empty
    std::vector<std::string> includes = {};  // the names of its includes, in order
};

/// The author's files of a pass's fragment shader. The first is the shader, the others are its
/// includes, each once. Their `#include` lines name files of this list. Constants have the values
/// of the look, and the macro of its driver is defined. For a pass of another program's format this
/// is its translated text without includes.
Result<std::vector<EffectFile>> effect_files(const Look& look, const Pass& pass);

/// One text with all includes of the first file in place.
std::string joined_text(const std::vector<EffectFile>& files);
