// Single fragment shaders: everything that reads the text before a compiler.

#include "formats/fragment/varyings.h"
#include "formats/glsl/modern_glsl.h"
#include "fuzz/fuzz_files.h"
#include "glsl/annotations/hint.h"
#include "glsl/compile/version_line.h"
#include "glsl/limits/bounds.h"
#include "glsl/text/declarations.h"
#include "glsl/text/include.h"

#include <algorithm>

void fuzz_one(std::string_view input) {
    const std::string modern = modern_glsl(input, {{"varying", "in"}, {"gl_FragColor", "color"}});
    require(std::ranges::count(modern, '\n') == std::ranges::count(input, '\n'),
            "every line stays where it was");
    GlslWords words;
    add_words(input, words);
    const Stage stage = builtin_stage(modern_glsl_start(words) + modern);
    Diagnostics problems;
    const std::vector<FragmentVarying> varyings = find_varyings(stage.text);
    require_locations(vertex_stage_for(varyings, stage, problems));
    for (const Declaration& declared : find_declarations(stage.text))
        parse_hints(declared.comments, stage, problems);
    check_version(stage);
    find_limit_violation(stage.text);
}
