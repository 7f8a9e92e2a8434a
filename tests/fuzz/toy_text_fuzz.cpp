// Shadertoy shaders as text: Common, Buffer A and Image, up to the text for the compiler.

#include "base/text.h"
#include "formats/shadertoy/shadertoy_files.h"
#include "formats/shadertoy/shadertoy_look.h"
#include "fuzz/fuzz_files.h"
#include "glsl/text/include.h"

#include <array>

void fuzz_one(std::string_view input) {
    using Kind = ShadertoyPass::Kind;
    constexpr std::array kinds{Kind::image, Kind::common, Kind::buffer};
    Shadertoy shadertoy;
    for (const std::string_view text : split(input, '\f')) {
        if (shadertoy.passes.size() == kinds.size())
            break;
        is_shadertoy_text(text);
        ShadertoyPass pass;
        pass.kind = kinds[shadertoy.passes.size()];
        pass.name = shadertoy_pass_name(pass.kind, 0);
        pass.code = builtin_stage(std::string(text));
        pass.has_explicit_inputs = false;
        shadertoy.passes.push_back(std::move(pass));
    }
    Diagnostics warnings;
    const auto look = look_of_shadertoy(shadertoy, "folder", warnings);
    require(look.has_value(), "a shader with an Image is a look");
    for (const Pass& pass : look->passes)
        require_locations(pass.fragment);
}
