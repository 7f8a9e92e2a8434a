#pragma once

#include "base/byte_store.h"

#include <memory>

struct Roots;

/// What compilers and the driver made of shaders in former runs of this program, in the person's
/// cache folder; null where there is none. Shared by the threads that open looks.
std::shared_ptr<ByteStore> kept_shaders(const Roots& roots);
