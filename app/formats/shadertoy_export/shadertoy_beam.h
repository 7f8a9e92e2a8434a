#pragma once

#include "base/diagnostic.h"
#include "formats/effect/effect_request.h"

#include <optional>
#include <string>
#include <vector>

/// The beam of a look. Shadertoy draws no points: Buffer A has a table of them, and each pixel adds
/// up those near it.
struct ShadertoyBeam {
    Pass pass;                        // as the look draws it, with its name in the reduced look
    int points = 4096;                // in a frame
    std::string signal;               // constants and functions of the signal
    std::vector<std::string> losses;  // a sentence per item
};

/// A look whose beam pass only fills the screen, and without unused passes. The bloom is read tap
/// by tap, because a pyramid needs too many buffers.
struct BeamlessLook {
    Look look;
    Values values;
    std::optional<ShadertoyBeam> beam;  // nullopt: the look has none, and is unchanged
};

/// Takes the beam out of a look. The error is the reason why Shadertoy can't draw it.
Result<BeamlessLook> without_beam(const EffectRequest& request);

/// Gives the beam's pass of the reduced look its shaders again.
void put_back(ShadertoyBeam& beam, Look& reduced);

/// A value that the beam's vertex shader gives to its fragment shader.
struct ShadertoyPassedValue {
    std::string name;
    std::string type;  // "float" to "vec4"
};

/// The values that both stages name. The error is a type that the table can't hold.
Result<std::vector<ShadertoyPassedValue>> shadertoy_passed_values(const Pass& pass);

/// The entry of Buffer A, after the vertex shader. Its channel 0 is itself.
std::string shadertoy_table_entry(const ShadertoyBeam& beam,
                                  const std::vector<ShadertoyPassedValue>& passed,
                                  const std::string& settings, const std::string& inputs);

/// A function vec4 drawn_NAME(ivec2 at): the light of all points at a pixel. `prefix`: of the
/// fragment shader's names. `result`: its output. `channel`: of Buffer A.
std::string shadertoy_beam_sum(const ShadertoyBeam& beam,
                               const std::vector<ShadertoyPassedValue>& passed,
                               const std::string& prefix, const std::string& result, int channel);
