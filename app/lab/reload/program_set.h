#pragma once

#include "lab/reload/built_look.h"

#include <memory>
#include <utility>

/// The programs of the open look.
class ProgramSet {
public:
    /// Programs in which every parameter is a uniform. A look must be open.
    const Programs& generic() const { return *m_generic; }
    /// All programs that draw the look now; null: none is open. Later builds reuse them.
    const std::shared_ptr<const Programs>& shown() const { return m_shown; }
    void set(Programs generic) {
        m_generic = std::move(generic);
        m_shown = std::make_shared<const Programs>(*m_generic);
    }
    void add_specialized(const Programs& programs) {
        m_shown = std::make_shared<const Programs>(joined(*m_generic, programs));
    }

    /// The static values that the picture is specialised for; null: not specialised. An edit of the
    /// look is specialised for the same values, so that its picture stays as fast.
    const std::shared_ptr<const SpecializationKey>& key() const { return m_key; }
    void set_key(std::shared_ptr<const SpecializationKey> key) { m_key = std::move(key); }

private:
    std::optional<Programs> m_generic;
    std::shared_ptr<const Programs> m_shown;
    std::shared_ptr<const SpecializationKey> m_key;
};
