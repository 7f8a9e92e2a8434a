#pragma once

#include "model/look/look.h"

#include <array>

namespace gpu {

/// While it lives GL's state is what every pass of a look starts from; after it nothing of that is
/// left, so that a toolkit may draw next.
class DrawScope {
public:
    DrawScope();
    ~DrawScope();
    DrawScope(const DrawScope&) = delete;
    DrawScope& operator=(const DrawScope&) = delete;
};

/// From here to the end of the scope draws reach only columns `first` to `end` - 1 of a target.
void limit_columns(int first, int end);
/// The same of rows, counted from the bottom.
void limit_rows(int first, int end);
/// They reach all of it again.
void lift_limits();

/// How what is drawn next meets what is there. Alpha is unassociated.
void set_blend(Blend blend);
/// Colours are added; alpha stays what it is.
void set_blend_onto();

/// Three vertices without attributes.
void draw_triangle();
void draw_points(int count);
/// Strips of four vertices, one an instance.
void draw_quads(int instances);

/// Whether a fragment may read the texel that it writes, and no other, of its own target.
bool can_read_own_target();
/// To be called before each such draw.
void make_own_target_readable();

/// From here on draws go to the window, to `extent` pixels of it.
void bind_screen(Extent extent);
/// Fills the window.
void clear_screen(std::array<float, 4> rgba);

/// Waits until all that was asked for is done; makes objects of this thread good for others.
void finish();

}  // namespace gpu
