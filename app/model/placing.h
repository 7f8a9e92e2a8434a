#pragma once

#include "model/picture.h"
#include "model/source_spec.h"

/// The size of what placed() makes.
Extent placed_extent(Extent picture, const SourceSpec& source, Extent viewport);

/// The picture as a look reads it that draws `viewport` pixels and takes its source from side to
/// side: cut, or with black around it, by the fit and pixel aspect of `source`. Its own pixels stay
/// as they are, but for Fit::integer, which repeats each until a pixel is one of the viewport.
Picture placed(const Picture& picture, const SourceSpec& source, Extent viewport);
