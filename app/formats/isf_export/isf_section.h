#pragma once

#include "formats/effect/effect_files.h"
#include "formats/effect/effect_uniforms.h"
#include "formats/isf_export/isf_images.h"
#include "formats/isf_export/isf_inputs.h"

#include <map>
#include <set>
#include <string>
#include <vector>

/// What the sections of one ISF file share.
struct IsfShared {
    const Look& look;    // reduced
    const Look& author;  // as written
    const IsfImages& images;
    const std::map<std::string, IsfControl>& controls;  // by name of the parameter
    std::set<std::string> globals = {};                 // names that are declared already
};

/// A pass of an ISF file.
struct IsfSection {
    std::string text;   // functions and constants
    std::string entry;  // the function that draws the pass; its result is in `result`
    std::string result;
};

/// Writes the section of a pass. The error is the reason why ISF can't hold it.
Result<IsfSection> isf_section(std::size_t pass, const EffectUniforms& uniforms, IsfShared& shared);
