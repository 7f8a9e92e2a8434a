#pragma once

#include "gpu/objects/canvas.h"
#include "graph/executor/executor.h"
#include "graph/inspect/viewer.h"
#include "lab/inspect/rota.h"

#include <optional>
#include <string>
#include <vector>

/// A small picture of every pass of the open look, one of them drawn anew at a time.
class Thumbnails {
public:
    /// To be called every turn while they are shown, `height` device pixels each.
    void update(Viewer& viewer, const Executor& executor, int height, double seconds);
    /// Nobody looks any more.
    void stop();

    /// Null until it has been drawn.
    const gpu::Texture* picture(std::size_t pass) const;
    /// Some do not show what their passes have now.
    bool is_owing() const { return m_rota.is_owing(); }

private:
    void draw(Viewer& viewer, const Executor& executor, std::size_t pass);

    std::vector<std::string> m_passes;  // names: another look has others
    int m_height = 0;
    std::vector<std::optional<gpu::Texture>> m_pictures;
    Rota m_rota;
};
