#include "lab/frame/heavy_pass_notice.h"

#include "lab/frame/heavy_pass.h"

#include <fmt/format.h>

#include <utility>

namespace {
constexpr const char* subject = "heavy pass";
}

void HeavyPassNotice::update() {
    const Renderer& renderer = *m_work.renderer;
    const std::vector<Pass>& passes = renderer.executor().look().passes;
    const std::vector<double>& latest = renderer.times().pass_milliseconds();
    const auto is_over = [&](std::size_t pass, double milliseconds) {
        return pass < passes.size() && pass < latest.size() && latest[pass] > milliseconds &&
               !m_passes.switches().bypassed.contains(passes[pass].name);
    };
    if (const auto known = find_pass(renderer.executor().look(), m_pass);
        !known || !is_over(static_cast<std::size_t>(*known), 0.5 * heavy_pass_milliseconds))
        withdraw();
    const auto heavy = heavy_pass(renderer.times().passes());
    if (!heavy || !is_over(*heavy, heavy_pass_milliseconds))
        return;
    m_pass = passes[*heavy].name;
    if (std::exchange(m_was_shown, true))
        return;
    m_work.messages.ask(
        fmt::format("Pass \"{}\" takes {:.1f} s per frame", m_pass, latest[*heavy] / 1000.0),
        section().entries, subject);
}

void HeavyPassNotice::withdraw() {
    if (!std::exchange(m_pass, {}).empty())
        m_work.messages.withdraw(subject);
}

void HeavyPassNotice::reset() {
    withdraw();
    m_was_shown = false;
}

MenuSection HeavyPassNotice::section() const {
    const auto pass = m_work.document ? find_pass(m_work.document->look(), m_pass) : std::nullopt;
    if (!pass)
        return MenuSection{"Heavy pass"};
    return heavy_pass_section(m_work.document->look().passes[static_cast<std::size_t>(*pass)],
                              m_work.size.chosen());
}
