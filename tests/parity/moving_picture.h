#pragma once

#include "model/look/picture.h"
#include "parity/plain_chain.h"

namespace plain {

/// A picture of a game, as it were, that moves: shades, edges, single pixels and noise; each frame
/// another one, the same in every run.
Bytes moving_picture(Extent extent, int frame);

/// The same as the program holds pictures.
Picture picture_of(const Bytes& bytes);

}  // namespace plain
