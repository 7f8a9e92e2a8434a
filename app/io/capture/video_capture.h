#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <optional>
#include <string>

/// Gives the pictures of a live source. Used by one thread.
class VideoCapture {
public:
    virtual ~VideoCapture() = default;

    /// Waits at most `seconds` for a new picture, display-encoded RGB. nullopt: it has not changed.
    /// After an error it gives no more pictures; open it again.
    virtual Result<std::optional<Picture>> read(double seconds) = 0;
    /// Why the picture is incomplete or old; "": it is neither.
    virtual std::string notice() const { return {}; }
    /// Whether it waits for the user, who must choose in a dialog of the desktop.
    virtual bool asks_user() const { return false; }
    /// Pictures per second, if the input states it; 0: no constant rate.
    virtual double rate() const { return 0.0; }
};
