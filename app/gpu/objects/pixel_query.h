#pragma once

#include "gpu/objects/name.h"

namespace gpu {

void delete_pixel_query(GLuint id);

/// Whether what was drawn between begin and end has coloured any pixel at all.
class PixelQuery {
public:
    PixelQuery();

    /// Forgets what was asked before.
    void begin();
    void end();

    /// Whether the answer is here; never waits.
    bool has_come() const;
    /// Waits where it is not.
    bool is_any() const;

    /// What is drawn up to end_condition() counts only if some pixel was: the GPU sees to it.
    void begin_condition() const;
    static void end_condition();

private:
    Name<delete_pixel_query> m_name;
};

}  // namespace gpu
