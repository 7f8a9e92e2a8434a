#include "lab/reload/specialization.h"

#include "model/look/value_changes.h"

#include <algorithm>
#include <utility>

namespace {
constexpr double seconds_per_update = 0.012;  // of first draws

std::set<std::string> moving_in(const Modulations& modulations) {
    std::set<std::string> names;
    for (const auto& [name, modulation] : modulations)
        names.insert(name);
    return names;
}
}  // namespace

void Specialization::stop() {
    m_static_seconds = 0.0;
    m_is_requested = false;
    m_pending.reset();
    m_loader.worker().queue().cancel(JobKind::specialization);
}

bool Specialization::is_static(const DocumentState& state) const {
    return state.values == m_values && state.modulations == m_modulations;
}

void Specialization::update(const Drawn& drawn, Renderer& renderer, bool is_quiet,
                            double wall_seconds) {
    constexpr double longest_update = 0.1;
    constexpr double enough_seconds = 2.0;
    const bool is_specialized = renderer.executor().programs().is_specialized();
    // A comparison draws both pictures with generic programs.
    m_loader.programs().set_key(is_specialized && !renderer.executors().variant() ? m_key
                                                                                  : nullptr);
    if (!is_quiet || !is_static(drawn.state)) {
        stop();
        follow_values(m_values, drawn.state.values);
        m_modulations = drawn.state.modulations;
        return;
    }
    m_static_seconds += std::min(wall_seconds, longest_update);
    if (!m_is_requested && m_static_seconds > enough_seconds && !is_specialized)
        request(drawn, renderer);
    if (auto built = m_loader.worker().queue().take(JobKind::specialization);
        built && built->programs)
        m_pending = std::make_unique<PendingLook>(std::move(*built));
    const bool has_unfinished_frame =
        renderer.has_unfinished_frame() && !renderer.replay().is_running();
    if (!m_pending || has_unfinished_frame ||
        !m_pending->update({m_loader.programs().shown().get(), drawn.picture}, seconds_per_update))
        return;
    const BuiltLook built = std::exchange(m_pending, nullptr)->take();
    m_loader.programs().add_specialized(*built.programs);
    use(*built.programs, drawn, renderer);
}

void Specialization::request(const Drawn& drawn, const Renderer& renderer) {
    m_is_requested = true;
    auto key = std::make_shared<const SpecializationKey>(
        SpecializationKey{m_values, renderer.executor().plan(), moving_in(m_modulations)});
    m_loader.build(
        {.kind = JobKind::specialization,
         .specialization = std::make_shared<const SpecializationRequest>(
             SpecializationRequest{drawn.document.drawn_look(), std::move(key), drawn.images})});
}

void Specialization::use(Programs programs, const Drawn& drawn, Renderer& renderer) {
    std::set<std::string> moving = moving_in(drawn.state.modulations);
    m_key = std::make_shared<const SpecializationKey>(
        SpecializationKey{drawn.state.values, renderer.executor().plan(), moving});
    m_loader.programs().set_key(m_key);
    renderer.drop_frame();
    renderer.executors().picture().specialize(std::move(programs), std::move(moving));
}

void Specialization::draw(SpecializedLook specialized, const Drawn& drawn, Renderer& renderer) {
    const SpecializationKey& key = *specialized.key;
    m_loader.programs().add_specialized(specialized.programs);
    const bool is_same_plan =
        std::ranges::equal(renderer.executor().plan().targets, key.plan.targets, {},
                           &PlannedTarget::onto, &PlannedTarget::onto);
    if (is_same_plan && moving_in(drawn.state.modulations) == key.moving &&
        changed_parameters(drawn.document.look(), key.values, drawn.state.values).empty())
        use(std::move(specialized.programs), drawn, renderer);
}
