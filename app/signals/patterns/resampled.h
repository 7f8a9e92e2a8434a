#pragma once

#include "model/look/picture.h"

/// The picture at another size. Each new pixel is the mean of the old area that it covers, so whole
/// multiples stay sharp.
Picture resampled(const Picture& picture, Extent extent);
