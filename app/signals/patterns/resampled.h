#pragma once

#include "model/look/picture.h"

/// The picture at another size: each new pixel is the mean of what it covers of the old ones, so
/// that whole multiples stay sharp.
Picture resampled(const Picture& picture, Extent extent);
