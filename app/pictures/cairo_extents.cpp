// Replaces two functions of Cairo for librsvg: a library that is loaded with this module finds the
// module's functions first. librsvg requests the extents of each shape, which Cairo computes from
// all intersections of its lines. For a line with 5,000 corners this takes seconds. No outline
// depends on these extents, and those of the corners take no time.
#include <cairo.h>

extern "C" void cairo_fill_extents(cairo_t* context, double* x1, double* y1, double* x2,
                                   double* y2) {
    cairo_path_extents(context, x1, y1, x2, y2);
}

extern "C" void cairo_stroke_extents(cairo_t* context, double* x1, double* y1, double* x2,
                                     double* y2) {
    cairo_path_extents(context, x1, y1, x2, y2);
}
