#pragma once

#include "model/look/look.h"

#include <array>

namespace gpu {

/// Sets the GL state that every pass starts from, for its lifetime. The destructor resets it, so
/// that a toolkit can draw next.
class DrawScope {
public:
    DrawScope();
    ~DrawScope();
    DrawScope(const DrawScope&) = delete;
    DrawScope& operator=(const DrawScope&) = delete;
};

/// Until the end of the scope, draws affect only columns `first` to `end` - 1 of a target.
void limit_columns(int first, int end);
/// The same for rows, counted from the bottom.
void limit_rows(int first, int end);
/// Removes these limits.
void lift_limits();

/// Sets how draws combine with the target. Alpha is unassociated.
void set_blend(Blend blend);
/// Colours are added; the target's alpha is unchanged.
void set_blend_onto();

/// Three vertices without attributes.
void draw_triangle();
void draw_points(int count);
/// Triangle strips of four vertices, one per instance.
void draw_quads(int instances);

/// Whether a fragment may read its own texel of its target, and only that texel.
bool can_read_own_target();
/// Call before each such draw.
void make_own_target_readable();

/// Subsequent draws go to `extent` pixels of the window.
void bind_screen(Extent extent);
void clear_screen(std::array<float, 4> rgba);

/// Waits until all commands are done; objects made on this thread are then usable on others.
void finish();

}  // namespace gpu
