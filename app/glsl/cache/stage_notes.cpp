#include "glsl/cache/stage_notes.h"

#include "glsl/compile/check.h"

StageNotes find_notes(const Stage& stage) {
    StageNotes notes;
    notes.constants = find_constants(stage.text);
    for (const Declaration& declaration : find_declarations(stage.text)) {
        UniformNotes uniform{declaration.name, location_in(stage, declaration.line), {}, {}};
        uniform.hints = parse_hints(declaration.comments, stage, uniform.errors);
        if (!uniform.hints.empty() || !uniform.errors.empty())
            notes.uniforms.push_back(std::move(uniform));
    }
    return notes;
}
