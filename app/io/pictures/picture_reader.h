#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <cstdint>
#include <optional>

/// Pictures that follow each other, read one at a time; used by one thread at a time.
class PictureReader {
public:
    virtual ~PictureReader() = default;

    /// The picture with that number, from 0; nothing where there are only so many. Quickest for
    /// each number after the one before it. An error is of this picture; the next may be good.
    virtual Result<std::optional<Picture>> read(std::int64_t number) = 0;
    /// How many there are; nothing until that is known.
    virtual std::optional<std::int64_t> count() const = 0;
    /// Pictures a second, as the file says; 0: it does not say.
    virtual double rate() const { return 0.0; }
};
