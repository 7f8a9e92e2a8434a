#pragma once

#include "model/look/picture.h"
#include "model/picture/source_raster.h"
#include "model/picture/source_spec.h"

#include <optional>
#include <string_view>

/// The size of what placed() makes.
Extent placed_extent(Extent picture, const SourceSpec& source, Extent viewport);

/// The picture as a look reads it that draws `viewport` pixels and takes its source from side to
/// side: cut, or with black around it, by the fit and pixel aspect of `source`. Its own pixels stay
/// as they are, but for Fit::integer, which repeats each until a pixel is one of the viewport, and
/// where more than 33 million pixels would be made, of which means are taken first.
Picture placed(const Picture& picture, const SourceSpec& source, Extent viewport);

/// Width to height of a pixel of what placed() makes of a picture.
double placed_aspect(const SourceSpec& source, Extent picture);

/// Where the lines and columns of a picture lie in what placed() makes of it.
SourceRaster placed_raster(Extent picture, const SourceSpec& source, Extent viewport);

/// What shape a picture has that is as large as its view.
enum class ViewShape {
    view,          // it fills the view
    source,        // that of the source, by its pixels' aspect
    whole_pixels,  // each of the source's lines the same whole number of lines; where not even one
                   // fits, as `source`
};

/// "view", "source", "whole pixels".
std::string_view shape_name(ViewShape shape);
std::optional<ViewShape> find_shape(std::string_view name);

/// The largest picture of that shape in a view, px; the view itself for an empty source.
Extent shaped(Extent view, ViewShape shape, Extent source, double pixel_aspect);
