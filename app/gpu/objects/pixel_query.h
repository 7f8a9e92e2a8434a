#pragma once

#include "gpu/objects/name.h"

namespace gpu {

void delete_pixel_query(GLuint id);

/// An occlusion query: whether the draws between begin and end wrote any pixel.
class PixelQuery {
public:
    PixelQuery();

    /// Discards the previous result.
    void begin();
    void end();

    /// Whether the result is available; never waits.
    bool is_available() const;
    /// Waits for the result.
    bool is_any_passed() const;

    /// The GPU discards the draws up to end_condition() if the query found no pixel.
    void begin_condition() const;
    static void end_condition();

private:
    Name<delete_pixel_query> m_name;
};

}  // namespace gpu
