#pragma once

#include "formats/effect/effect_look.h"

#include <map>
#include <set>
#include <string>

/// Which buffer of Shadertoy each pass of a look gets. All buffers have the size of the picture, so
/// a smaller pass is at the bottom left of its buffer.
struct ShadertoyPlan {
    const Look& look;                         // reduced
    std::string source_pass;                  // not drawn: its readers decode the picture; or ""
    bool has_levels = false;                  // Buffer A has mip levels of the picture
    std::map<std::string, int> buffers = {};  // by name of the pass; 0: Buffer A
    std::string beam = {};               // the pass of the beam, whose table is Buffer A; or ""
    std::set<std::string> inlined = {};  // passes that are drawn where they are read

    /// Whether an input reads the picture that the user connects.
    bool is_source(const Input& input) const;
    /// Whether the picture becomes linear light where it is read.
    bool decodes() const;
    const Pass& pass(const std::string& name) const;
    /// Whether a pass has the size of the picture.
    bool is_whole(const std::string& pass) const;
};

/// The plan of a look. `beam`: the pass of its beam; "": none. If a look with a beam needs too many
/// buffers, its first pass without a past is drawn where it is read.
ShadertoyPlan shadertoy_plan(const Effect& effect, const std::string& beam = "");

/// Why Shadertoy can't draw the plan; "" if it can. `size`: of the picture. `source`: of the
/// picture that the user connects.
std::string shadertoy_obstacle(const ShadertoyPlan& plan, Extent size, Extent source);

/// "Buffer A" for 0.
std::string shadertoy_buffer_name(int buffer);
