#include "graph/programs/programs.h"

#include "glsl/text/include.h"
#include "gpu/debug_names.h"
#include "gpu/objects/draw.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
const Stage& vertex_stage_of(const Pass& pass) {
    return pass.vertex.text->empty() ? fullscreen_vertex_stage() : pass.vertex;
}

// Reading the target of the same draw is undefined behaviour.
Diagnostics check_inputs(const Pass& pass) {
    Diagnostics problems;
    for (const Input& input : pass.inputs)
        if (input.from == Input::From::pass && input.name == pass.name && input.frames_ago == 0)
            problems.push_back(
                {pass.declared.file, pass.declared.line,
                 fmt::format("pass '{0}' can't read its own output. Use '{0}@1' for its previous "
                             "frame.",
                             pass.name)});
    return problems;
}

// Each program is used once. Two passes with the same text, such as a blur in x and in y, differ in
// their uniforms.
class Reusable {
public:
    explicit Reusable(const Programs* old) {
        if (old)
            m_left = old->passes;
    }

    std::shared_ptr<const gpu::Program> take(const PassProgram& wanted) {
        const auto found = std::ranges::find_if(m_left, [&](const PassProgram& had) {
            return had.program && had.fragment == wanted.fragment && had.vertex == wanted.vertex &&
                   had.draw == wanted.draw && had.set == wanted.set;
        });
        return found == m_left.end() ? nullptr : std::move(found->program);
    }

private:
    std::vector<PassProgram> m_left;
};

PassProgram wanted_for(const Pass& pass) {
    return {vertex_stage_of(pass).text, pass.fragment.text, pass.draw, pass.set, nullptr};
}

Result<PassProgram> build_pass(const Pass& pass, Reusable& reusable, ByteStore* store,
                               const std::shared_ptr<gpu::Context>& context) {
    Diagnostics problems = check_inputs(pass);
    PassProgram made = wanted_for(pass);
    made.program = reusable.take(made);
    if (!made.program) {
        auto program = gpu::Program::build(vertex_stage_of(pass), pass.fragment, store);
        if (program) {
            gpu::set_label(*program, pass.name);
            made.program = gpu::destroyed_in(context, std::move(*program));
        } else {
            problems.insert(problems.end(), program.error().begin(), program.error().end());
        }
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return made;
}
}  // namespace

Programs joined(Programs first, const Programs& second) {
    for (const PassProgram& other : second.passes)
        if (std::ranges::find(first.passes, other.program, &PassProgram::program) ==
            first.passes.end())
            first.passes.push_back(other);
    return first;
}

bool serves(const Programs& programs, const Look& look) {
    Reusable reusable(&programs);
    return std::ranges::all_of(
        look.passes, [&](const Pass& pass) { return reusable.take(wanted_for(pass)) != nullptr; });
}

Result<Programs> build_programs(const Look& look, const Programs* reuse, ByteStore* store,
                                PassProgress* progress,
                                const std::shared_ptr<gpu::Context>& context) {
    Programs programs{{}, context};
    Diagnostics problems;
    Reusable reusable(reuse);
    if (progress)
        progress->begin(PassProgress::Step::linking, look.passes.size());
    for (const Pass& pass : look.passes) {
        if (progress && !progress->next(pass.name))
            return fail({look.manifest, 0, "opening was cancelled"});
        auto made = build_pass(pass, reusable, store, context);
        if (made)
            programs.passes.push_back(std::move(*made));
        else
            problems.insert(problems.end(), made.error().begin(), made.error().end());
    }
    if (look.passes.empty())
        problems.push_back({look.manifest, 0, "the look has no passes"});
    if (!problems.empty())
        return fail(std::move(problems));
    gpu::finish();  // another context may use them from here on
    return programs;
}
