// Shadertoy shaders as JSON, in both dialects, up to the text for the compiler.

#include "formats/shadertoy/toy_json.h"
#include "formats/shadertoy/toy_look.h"
#include "fuzz/fuzz_files.h"

void fuzz_one(std::string_view input) {
    Diagnostics warnings;
    const auto toy = parse_toy_json(input, "toy.json", warnings);
    if (!toy)
        return require_reasons(toy.error());
    const auto look = look_of_toy(*toy, "folder", warnings);
    if (!look)
        return require_reasons(look.error());
    for (const Pass& pass : look->passes)
        require_places(pass.fragment);
}
