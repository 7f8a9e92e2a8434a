// Stands in for two functions of Cairo where librsvg calls them, as a library that is loaded with
// this module finds the module's functions first. librsvg asks for the extents of each shape, which
// Cairo finds from all crossings of its lines: of a line with 5,000 corners that takes seconds. No
// outline depends on them, and the corners' own extents take no time.
#include <cairo.h>

extern "C" void cairo_fill_extents(cairo_t* context, double* x1, double* y1, double* x2,
                                   double* y2) {
    cairo_path_extents(context, x1, y1, x2, y2);
}

extern "C" void cairo_stroke_extents(cairo_t* context, double* x1, double* y1, double* x2,
                                     double* y2) {
    cairo_path_extents(context, x1, y1, x2, y2);
}
