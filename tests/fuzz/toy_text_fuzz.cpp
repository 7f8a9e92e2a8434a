// Shadertoy shaders as text: Common, Buffer A and Image, up to the text for the compiler.

#include "base/text.h"
#include "formats/shadertoy/toy_files.h"
#include "formats/shadertoy/toy_look.h"
#include "fuzz/fuzz_files.h"
#include "glsl/text/include.h"

#include <array>

void fuzz_one(std::string_view input) {
    using Kind = ToyPass::Kind;
    constexpr std::array kinds{Kind::image, Kind::common, Kind::buffer};
    Toy toy;
    for (const std::string_view text : split(input, '\f')) {
        if (toy.passes.size() == kinds.size())
            break;
        is_toy_text(text);
        ToyPass pass;
        pass.kind = kinds[toy.passes.size()];
        pass.name = toy_pass_name(pass.kind, 0);
        pass.code = builtin_stage(std::string(text));
        pass.is_wired = false;
        toy.passes.push_back(std::move(pass));
    }
    Diagnostics warnings;
    const auto look = look_of_toy(toy, "folder", warnings);
    require(look.has_value(), "a shader with an Image is a look");
    for (const Pass& pass : look->passes)
        require_places(pass.fragment);
}
