#pragma once

#include "base/shared.h"
#include "glsl/constants/specialized_text.h"
#include "model/plan/plan.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

/// A cache of specialised texts. Passes share texts, and an edit leaves most of them unchanged.
class SpecializedTexts {
public:
    /// Removes texts that were not used in the last 8 looks.
    void begin_look();
    /// As specialized_text().
    SharedText of(const SharedText& text,
                  const std::map<std::string, SpecializedUniform>& uniforms);

private:
    struct Specialized {
        SharedText text;
        std::map<std::string, SpecializedUniform> uniforms;
        SharedText made;
        int age = 0;  // looks since its last use
    };
    std::vector<Specialized> m_specialized;
};

/// The look with these values as constants in its texts, for specialised programs. They can draw
/// only with these values and this plan. Code that these switch off is not compiled. Events, orbits
/// and parameters for which `moves` is true stay uniforms.
Look specialized_look(Look look, const Values& values, const Plan& plan,
                      const std::function<bool(const Parameter&)>& moves, SpecializedTexts& texts);
