#include "formats/bare/bare_names.h"

#include "base/text.h"

#include <algorithm>
#include <array>

const std::vector<BuiltInUniform>& bare_built_ins() {
    static const std::vector<BuiltInUniform> all{// glslViewer and The Book of Shaders
                                                 {"u_time", BuiltIn::time_before},
                                                 {"u_delta", BuiltIn::time_delta},
                                                 {"u_frame", BuiltIn::frame_before},
                                                 {"u_resolution", BuiltIn::target_resolution},
                                                 {"u_mouse", BuiltIn::mouse},
                                                 // three.js and its like
                                                 {"time", BuiltIn::time_before},
                                                 {"resolution", BuiltIn::target_resolution},
                                                 {"uTime", BuiltIn::time_before},
                                                 {"uResolution", BuiltIn::target_resolution},
                                                 {"iTime", BuiltIn::time_before},
                                                 {"iGlobalTime", BuiltIn::time_before},
                                                 {"iTimeDelta", BuiltIn::time_delta},
                                                 {"iFrame", BuiltIn::frame_before},
                                                 {"iFrameRate", BuiltIn::frame_rate},
                                                 {"iResolution", BuiltIn::target_resolution},
                                                 {"iMouse", BuiltIn::press}};
    return all;
}

bool is_bare_source(std::string_view sampler) {
    // GameMaker, three.js, raylib, PixiJS
    constexpr std::array<std::string_view, 4> names{"gm_BaseTexture", "tDiffuse", "texture0",
                                                    "uSampler"};
    return std::ranges::find(names, sampler) != names.end();
}

const char* bare_stand_in(std::string_view sampler) {
    return to_lower(sampler).find("noise") == std::string::npos ? "pattern:harbour"
                                                                : "pattern:noise";
}
