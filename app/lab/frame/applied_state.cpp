#include "lab/frame/applied_state.h"

#include "model/look/value_changes.h"

#include <algorithm>
#include <cassert>

// Constants in texts are applied when they are compiled.
std::vector<std::string> changed_uniforms(const Look& look, const Values& before,
                                          const Values& now) {
    std::vector<std::string> names = changed_parameters(look, before, now);
    std::erase_if(names,
                  [&](const std::string& name) { return find_parameter(look, name)->is_constant; });
    return names;
}

void copy_changes(std::optional<DocumentState>& applied, const DocumentState& state) {
    if (!applied)
        applied = state;
    // Names every member, so that a new one cannot be omitted.
    const auto& [values, signal, source, overrides, origin, stack, modulations, locks, files, tempo,
                 cues] = state;
    follow_values(applied->values, values);
    applied->signal = signal;
    applied->source = source;
    applied->overrides = overrides;
    applied->origin = origin;
    applied->stack = stack;
    applied->modulations = modulations;
    applied->locks = locks;
    applied->files = files;
    applied->tempo = tempo;
    applied->cues = cues;
    assert(*applied == state);
}
