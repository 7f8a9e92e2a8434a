#pragma once

#include "graph/targets/target.h"
#include "model/look/look.h"

#include <string>
#include <vector>

/// The targets of a look's passes, in their order.
class TargetSet {
public:
    /// The targets of `plan`. Targets of `old` with the same pass, size and format keep their
    /// contents. With another size they do so if the pass keeps them when resized. On failure
    /// `old` is unchanged.
    static Result<TargetSet> make(const Look& look, const Plan& plan, TargetSet& old);

    std::size_t size() const { return m_targets.size(); }
    Target& operator[](std::size_t pass) { return m_targets[pass].target; }
    const Target& operator[](std::size_t pass) const { return m_targets[pass].target; }

private:
    struct Named {
        std::string pass;
        Target target;
    };

    Target* find(const std::string& pass);
    void bind_shared();
    void set_labels();

    std::vector<Named> m_targets;
    std::vector<gpu::Canvas> m_common;  // one per m_planned_common
    std::vector<CommonPicture> m_planned_common;
};
