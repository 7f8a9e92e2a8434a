#pragma once

#include "model/look/look.h"
#include "model/look/picture.h"

#include <string>

/// The first frame of a built-in look for the picture `source`, at the size of `source`, with every
/// target in 32-bit floats. Returns the target of `pass` ("": the last one).
Picture drawn_look(const std::string& look, const Picture& source, const Values& values,
                   const std::string& pass = "");

/// The same for a picture of `size`, in frame `number` at 60 fps.
Picture drawn_look_at(const std::string& look, Extent size, const Picture& source,
                      const Values& values, int number = 1, const std::string& pass = "");

/// A picture of one colour in linear light.
Picture flat_field(Extent extent, float red, float green, float blue);

/// The mean of a channel over the pixels of a rectangle.
double mean_of(const Picture& picture, std::size_t channel, int x, int y, Extent extent);
