#pragma once

#include "formats/effect/effect_uniforms.h"
#include "formats/shadertoy_export/shadertoy_beam.h"
#include "formats/shadertoy_export/shadertoy_constants.h"
#include "formats/shadertoy_export/shadertoy_images.h"

#include <map>
#include <set>
#include <string>

/// What the passes of one Shadertoy shader share.
struct ShadertoyShared {
    const ShadertoyPlan& plan;
    const Look& author;                                         // as written
    const std::vector<EffectUniforms>& uniforms;                // of each pass
    const std::map<std::string, ShadertoyConstant>& constants;  // by name of the parameter
    std::set<std::string, std::less<>> in_common = {};  // parameters whose constants are in Common
    const ShadertoyBeam* beam = nullptr;                // of the plan's beam
};

/// Writes the code of a pass, with `mainImage` as its entry. The error is the reason why Shadertoy
/// can't hold it. `images` are those of the pass.
Result<std::string> shadertoy_code(std::size_t pass, const ShadertoyShared& shared,
                                   ShadertoyImages& images);

/// The code of Buffer A with the points of the beam, from its vertex shader. `pass`: of the beam.
Result<std::string> shadertoy_table_code(std::size_t pass, const ShadertoyShared& shared,
                                         ShadertoyImages& images);
