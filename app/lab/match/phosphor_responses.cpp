#include "lab/match/phosphor_responses.h"

#include "lab/offline/impulse.h"

#include <algorithm>
#include <optional>

namespace {
constexpr Extent size{64, 48};

std::optional<std::size_t> pass_with_history(const Look& look) {
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (std::ranges::any_of(look.passes[i].inputs, [&](const Input& input) {
                return input.frames_ago > 0 && input.name == look.passes[i].name;
            }))
            last = i;
    return last;
}

bool has_tubes(const Look& look) {
    return std::ranges::any_of(look.parameters, [](const Parameter& parameter) {
        return parameter.photo_role == PhotoRole::tube;
    });
}
}  // namespace

Result<PhosphorResponses> PhosphorResponses::create(PreparedLook prepared, double fps,
                                                    JobProgress& work) {
    const auto pass = pass_with_history(prepared.document.look());
    if (!pass)
        return fail({{},
                     0,
                     "The light of this look does not fade. Choose a look with a phosphor, such as "
                     "phosphor."});
    auto offline = Offline::create(std::move(prepared), size, fps * steps);
    if (!offline)
        return fail(offline.error());
    return PhosphorResponses(std::move(*offline), *pass, fps, work);
}

PhosphorResponses::PhosphorResponses(Offline offline, std::size_t pass, double fps,
                                     JobProgress& work)
    : m_offline(std::move(offline)),
      m_document(m_offline.document()),
      m_pass(pass),
      m_fps(fps),
      m_work(work) {}

Result<std::vector<glm::dvec3>> PhosphorResponses::response(const Values& values, int frames) {
    Document document = m_document;
    document.amend([&](DocumentState& state) {
        for (const auto& [name, value] : values)
            state.values[name] = value;
    });
    if (auto begun = m_offline.start_again(std::move(document), m_fps * steps); !begun)
        return fail(begun.error());
    ImpulseRequest request;
    request.fps = m_fps * steps;
    request.seconds = frames / m_fps;
    request.pass = m_pass;
    const auto impulse = fire_impulse(m_offline, size, request, m_work);
    if (!impulse)
        return fail(impulse.error());
    const PassImpulse& pass = impulse->passes.front();
    const bool has_colors = has_tubes(m_document.look());
    std::vector<glm::dvec3> light;
    for (std::size_t i = 0; i < pass.light.size(); ++i)
        light.push_back(has_colors
                            ? glm::dvec3(pass.colors[i][0], pass.colors[i][1], pass.colors[i][2])
                            : glm::dvec3(pass.light[i]));
    return light;
}
