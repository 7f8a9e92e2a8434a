#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <optional>
#include <string>
#include <string_view>

/// Splits a stream of binary PPM pictures (P6, 8 bits), as ffmpeg writes them.
class PpmStream {
public:
    void add(std::string_view bytes) { m_bytes.append(bytes); }
    /// The next whole picture, display-encoded RGB; nullopt: more bytes are needed.
    Result<std::optional<Picture>> take();

private:
    std::string m_bytes;
};
