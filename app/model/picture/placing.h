#pragma once

#include "model/look/picture.h"
#include "model/picture/source_raster.h"
#include "model/picture/source_spec.h"

#include <optional>
#include <string_view>

/// The size of the result of placed().
Extent placed_extent(Extent picture, const SourceSpec& source, Extent viewport);

/// The picture for a look that draws `viewport` pixels and maps its source to the whole target. It
/// is cropped or gets a black border, by the fit and pixel aspect of `source`. Pixels are
/// unchanged, except for Fit::integer, which repeats them to match pixels of the viewport. Results
/// of more than 33 million pixels are averaged down first.
Picture placed(const Picture& picture, const SourceSpec& source, Extent viewport);

/// Width / height of a pixel in the result of placed().
double placed_aspect(const SourceSpec& source, Extent picture);

/// The position of a picture's lines and columns in the result of placed().
SourceRaster placed_raster(Extent picture, const SourceSpec& source, Extent viewport);

/// The shape of a picture within its view.
enum class ViewShape {
    view,          // fills the view
    source,        // of the source, with its pixel aspect
    whole_pixels,  // scales the source by an integer; if not even 1 fits, as `source`
};

/// "view", "source", "whole pixels".
std::string_view shape_name(ViewShape shape);
std::optional<ViewShape> find_shape(std::string_view name);

/// The largest picture of this shape in a view, px; the view itself for an empty source.
Extent shaped(Extent view, ViewShape shape, Extent source, double pixel_aspect);
