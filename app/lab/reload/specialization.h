#pragma once

#include "lab/document/document.h"
#include "lab/reload/look_loader.h"
#include "lab/rendering/renderer.h"

#include <memory>

/// Draws the open look with specialised programs while its values are static: two seconds after the
/// last change. On a software renderer a frame then takes about half the time.
class Specialization {
public:
    explicit Specialization(LookLoader& loader) : m_loader(loader) {}

    /// The open look, and the state that is drawn.
    struct Drawn {
        const Document& document;
        const DocumentState& state;  // that is drawn
        const ImageTextures& images;
        Extent picture;  // px
    };
    /// Call once per update. `is_quiet`: nothing changes values, and nothing else needs the worker
    /// thread or the GPU.
    void update(const Drawn& drawn, Renderer& renderer, bool is_quiet, double wall_seconds);
    /// Restarts: call if something other than values changed.
    void stop();
    /// Draws an edited look with the specialised programs that were built with it. Without effect
    /// if their values or the plan changed meanwhile.
    void draw(SpecializedLook specialized, const Drawn& drawn, Renderer& renderer);

private:
    bool is_static(const DocumentState& state) const;
    void request(const Drawn& drawn, const Renderer& renderer);
    void use(Programs programs, const Drawn& drawn, Renderer& renderer);

    LookLoader& m_loader;
    Values m_values;
    Modulations m_modulations;
    double m_static_seconds = 0.0;
    bool m_is_requested = false;
    std::unique_ptr<PendingLook> m_pending;          // null: not built yet
    std::shared_ptr<const SpecializationKey> m_key;  // of the programs in use
};
