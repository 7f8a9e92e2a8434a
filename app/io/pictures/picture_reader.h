#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <cstdint>
#include <optional>

/// Reads a sequence of pictures one at a time; not thread-safe.
class PictureReader {
public:
    virtual ~PictureReader() = default;

    /// The picture with this number, from 0; nullopt after the last. Fastest for consecutive
    /// numbers. An error concerns only this picture; the next may be good.
    virtual Result<std::optional<Picture>> read(std::int64_t number) = 0;
    /// The number of pictures; nullopt while unknown.
    virtual std::optional<std::int64_t> count() const = 0;
    /// Pictures per second from the file; 0 if unknown.
    virtual double rate() const { return 0.0; }
};
