// Shadertoy shaders as JSON, in both dialects, up to the text for the compiler.

#include "formats/shadertoy/shadertoy_json.h"
#include "formats/shadertoy/shadertoy_look.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    Diagnostics warnings;
    const auto shadertoy = parse_shadertoy_json(input, "toy.json", warnings);
    if (!shadertoy)
        return require_reasons(shadertoy.error());
    const auto look = look_of_shadertoy(*shadertoy, "folder", warnings);
    if (!look)
        return require_reasons(look.error());
    for (const Pass& pass : look->passes)
        require_locations(pass.fragment);
}
