#include "graph/warm_up/first_draws.h"

#include "glsl/text/include.h"
#include "gpu/objects/draw.h"
#include "graph/executor/nan_watch.h"
#include "graph/warm_up/warm_up_sizes.h"

#include <algorithm>
#include <cassert>

namespace {
bool is_known(const PassProgram& program, const Programs* known) {
    return known && std::ranges::any_of(known->passes, [&](const PassProgram& other) {
               return other.program == program.program;
           });
}

// Allocating large targets takes longer than drawing a band of them. Code that Mesa's llvmpipe
// (22.3) compiled for a few pixels was not always reused for more pixels. Code for a quarter of the
// size was.
PictureSizes sizes_for(const FirstDrawsInput& of) {
    const bool reads_source = of.look.driven_by == Driver::picture;
    if (of.size == FirstDrawsInput::Size::own)
        return {of.viewport, reads_source ? expected_source : of.viewport};
    const PictureSizes whole{of.viewport, expected_source};
    if (const auto quarter = quarter_equivalent(of.look, whole))
        return *quarter;
    return of.size == FirstDrawsInput::Size::small ? small_equivalent(of.look, whole) : whole;
}

Picture black(Extent extent) {
    const auto texels =
        static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height);
    return {extent, 3, Encoding::display, std::vector<float>(3 * texels)};
}

Frame first_frame(const Beam& beam) {
    Frame frame;
    frame.number = 1;
    frame.time = frame.time_delta = 1.0 / 60.0;
    frame.beam = beam;
    return frame;
}
}  // namespace

Result<PassProgram> idle_program() {
    Stage fragment;
    fragment.text = "#version 410 core\nvoid main() { discard; }\n";
    auto program = gpu::Program::build(fullscreen_vertex_stage(), fragment);
    if (!program)
        return fail(program.error());
    return PassProgram{{},
                       fragment.text,
                       Draw::fullscreen,
                       {},
                       std::make_shared<const gpu::Program>(std::move(*program))};
}

std::vector<PassProgram> new_programs(const Programs& programs, const Programs* known) {
    std::vector<PassProgram> found = programs.passes;
    std::erase_if(found, [known](const PassProgram& program) { return is_known(program, known); });
    return found;
}

FirstDraws::FirstDraws(const FirstDrawsInput& of, const PassProgram& idle) {
    Look stand_in = of.look;
    Programs drawn = of.programs;
    for (std::size_t i = 0; i < drawn.passes.size(); ++i) {
        if (!is_known(drawn.passes[i], of.known)) {
            m_new.push_back(i);
            continue;
        }
        drawn.passes[i] = idle;
        stand_in.passes[i].draw = Draw::fullscreen;
        stand_in.passes[i].inputs.clear();
        stand_in.passes[i].set.clear();
    }
    if (m_new.empty())
        return;
    m_executor = std::make_unique<Executor>(std::move(stand_in), std::move(drawn));
    if (make_ready(of))
        return;
    m_executor.reset();
    m_new.clear();  // loading the look reports the error
}

bool FirstDraws::make_ready(const FirstDrawsInput& of) {
    const PictureSizes sizes = sizes_for(of);
    const auto policy = of.programs.nan_detector ? NanPolicy::search : NanPolicy::off;
    m_executor->set_values(of.values);
    for (const auto& [name, texture] : of.images)
        m_executor->set_image(name, texture);
    const bool has_source =
        of.size != FirstDrawsInput::Size::own || of.look.driven_by == Driver::picture;
    return m_executor->set_displayed(of.seen).has_value() &&
           m_executor->resize(sizes.viewport, sizes.source).has_value() &&
           (!has_source || m_executor->set_source(black(sizes.source)).has_value()) &&
           std::make_shared<NanWatch>()->set_policy(policy, *m_executor).has_value();
}

const std::string& FirstDraws::next_pass() const {
    assert(!is_done());
    return m_executor->look().passes[m_new[m_done]].name;
}

void FirstDraws::draw_next() {
    assert(!is_done());
    const Beam beam{{-0.25f, 0.0f, 1.0f, 0.0f}, {0.25f, 0.0f, 1.0f, 0.0f}};
    // One band is enough, and does not block the GPU for long if the pass is slow.
    m_executor->drawer().warm_up_pass(first_frame(beam), m_new[m_done++]);
    gpu::finish();
}

void FirstDraws::draw_all(PassProgress& progress) {
    progress.begin(PassProgress::Step::drawing, total());
    while (!is_done() && progress.next(next_pass()))
        draw_next();
}

std::unique_ptr<Executor> FirstDraws::take_executor() {
    if (m_executor) {
        m_executor->clear_history();
        m_executor->drawer().set_observer(nullptr);
    }
    return std::move(m_executor);
}
