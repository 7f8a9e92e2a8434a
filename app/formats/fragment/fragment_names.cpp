#include "formats/fragment/fragment_names.h"

#include "base/text.h"

#include <algorithm>
#include <array>

std::vector<FragmentPass> fragment_passes(const GlslWords& words) {
    constexpr int max_buffers = 16;  // per kind
    std::vector<FragmentPass> passes;
    const auto add = [&](const char* define, const char* name) {
        for (int i = 0; i < max_buffers; ++i)
            if (std::string asked = define + std::to_string(i); words.contains(asked))
                passes.push_back({name + std::to_string(i), std::move(asked)});
    };
    add("BUFFER_", "u_buffer");
    add("DOUBLE_BUFFER_", "u_doubleBuffer");
    passes.push_back({"picture", {}});
    return passes;
}

const std::vector<BuiltInUniform>& fragment_built_ins() {
    static const std::vector<BuiltInUniform> all{// glslViewer and The Book of Shaders
                                                 {"u_time", BuiltIn::time_before},
                                                 {"u_delta", BuiltIn::time_delta},
                                                 {"u_frame", BuiltIn::frame_index},
                                                 {"u_resolution", BuiltIn::target_resolution},
                                                 {"u_mouse", BuiltIn::mouse},
                                                 {"u_date", BuiltIn::date_from_0},
                                                 // three.js and similar hosts
                                                 {"time", BuiltIn::time_before},
                                                 {"resolution", BuiltIn::target_resolution},
                                                 {"uTime", BuiltIn::time_before},
                                                 {"uResolution", BuiltIn::target_resolution},
                                                 {"iTime", BuiltIn::time_before},
                                                 {"iGlobalTime", BuiltIn::time_before},
                                                 {"iTimeDelta", BuiltIn::time_delta},
                                                 {"iFrame", BuiltIn::frame_index},
                                                 {"iFrameRate", BuiltIn::frame_rate},
                                                 {"iResolution", BuiltIn::target_resolution},
                                                 {"iMouse", BuiltIn::press}};
    return all;
}

bool is_fragment_source(std::string_view sampler) {
    // GameMaker, three.js, raylib, PixiJS
    constexpr std::array<std::string_view, 4> names{"gm_BaseTexture", "tDiffuse", "texture0",
                                                    "uSampler"};
    return std::ranges::find(names, sampler) != names.end();
}

bool is_drawn_by_viewer(std::string_view sampler) {
    constexpr std::array<std::string_view, 6> starts{
        "u_buffer", "u_doubleBuffer", "u_scene", "u_pyramid", "u_flood", "u_lightShadowMap"};
    return std::ranges::any_of(starts,
                               [&](std::string_view start) { return sampler.starts_with(start); });
}

const char* default_picture(std::string_view sampler) {
    return to_lower(sampler).find("noise") == std::string::npos ? "pattern:harbour"
                                                                : "pattern:noise";
}
