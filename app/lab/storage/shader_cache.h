#pragma once

#include "base/byte_store.h"

#include <memory>

struct Roots;

/// The on-disk shader cache in the user's cache folder: results of compilers and driver. Null: no
/// cache folder. The threads that open looks share it.
std::shared_ptr<ByteStore> shader_cache(const Roots& roots);
