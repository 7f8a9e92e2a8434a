#pragma once

#include "model/look/look.h"
#include "model/plan/plan.h"

/// Whether a pass uses a parameter: in its shaders, for its size, or for its repeat count.
bool is_used_by(const Look& look, std::size_t pass, const Parameter& parameter);

/// Whether a parameter sets a pass's size, repeat count or number of channels. A change discards
/// its previous pictures.
bool affects_target_size(const Look& look, std::size_t pass, const Parameter& parameter);

/// The same for any pass.
bool drives_size(const Look& look, const Parameter& parameter);

/// Whether it affects which passes are drawn onto another pass's target.
bool affects_aliasing(const Look& look, const Parameter& parameter);

/// Whether parameters reduce the pass, of size `extent`, to a single texel. Looks do this with
/// passes that are currently unused.
bool is_idle(const Look& look, std::size_t pass, Extent extent);

/// The next (by 1) or previous (by -1) pass that is not idle; wraps around.
std::size_t next_used_pass(const Look& look, const Plan& plan, std::size_t pass, int by);
