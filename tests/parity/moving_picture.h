#pragma once

#include "model/look/picture.h"
#include "parity/plain_chain.h"

namespace plain {

/// A moving test picture that resembles a game: gradients, edges, single pixels and noise. Each
/// frame differs; all runs give the same frames.
Bytes moving_picture(Extent extent, int frame);

/// The same picture as the program's Picture.
Picture picture_of(const Bytes& bytes);

}  // namespace plain
