#pragma once

#include "base/shared.h"
#include "glsl/constants/settled_text.h"
#include "model/plan/plan.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

/// What values made of texts lately: passes have texts in common, and an edit leaves most as they
/// were.
class SettledTexts {
public:
    /// What was not asked for in some looks is forgotten.
    void begin_look();
    /// As settled_text().
    SharedText of(const SharedText& text, const std::map<std::string, SettledUniform>& uniforms);

private:
    struct Settled {
        SharedText text;
        std::map<std::string, SettledUniform> uniforms;
        SharedText made;
        int age = 0;  // looks in which nobody asked for it
    };
    std::vector<Settled> m_settled;
};

/// The look with these values in its texts, for programs that are to draw with no others and by no
/// other plan: what these switch off is not compiled. `moves` says which parameters stay uniforms
/// all the same; events and orbits do.
Look settled_look(Look look, const Values& values, const Plan& plan,
                  const std::function<bool(const Parameter&)>& moves, SettledTexts& texts);
