#pragma once

#include "model/look/look.h"
#include "model/plan/plan.h"

/// Whether a pass uses a parameter: in its shaders, for its size, or for how often it draws.
bool is_used_by(const Look& look, std::size_t pass, const Parameter& parameter);

/// Whether it says how large a pass is, how often it draws or how many channels its target has: all
/// that it drew before is lost when that changes.
bool shapes_target(const Look& look, std::size_t pass, const Parameter& parameter);

/// Whether it decides which passes are drawn onto another's target.
bool decides_sharing(const Look& look, const Parameter& parameter);

/// Whether parameters have made the pass, `extent` texels large, a single one: so looks do with
/// passes that the picture is without at present.
bool is_idle(const Look& look, std::size_t pass, Extent extent);

/// The next pass (by 1) or the one before (by -1) that is not idle; past the last comes the first.
std::size_t next_used_pass(const Look& look, const Plan& plan, std::size_t pass, int by);
