// The part of Lab that tells what makes the window answer slowly.
#include "lab/heavy_pass.h"
#include "lab/lab.h"

#include <fmt/format.h>

#include <utility>

namespace {
constexpr const char* heavy_subject = "heavy pass";
}  // namespace

// Told once for a look, with what may be done about it, which stays on offer until the pass takes
// half of that: one that takes hardly more would come and go.
void Lab::follow_heavy_pass() {
    const std::vector<Pass>& passes = m_renderer->executor().look().passes;
    const std::vector<double>& latest = m_renderer->latest_pass_milliseconds();
    const auto is_over = [&](std::size_t pass, double milliseconds) {
        return pass < passes.size() && pass < latest.size() && latest[pass] > milliseconds &&
               !m_switches.bypassed.contains(passes[pass].name);
    };
    if (const auto known = find_pass(m_renderer->executor().look(), m_heavy_pass);
        !known || !is_over(static_cast<std::size_t>(*known), 0.5 * heavy_pass_milliseconds))
        forget_heavy_pass();
    const auto heavy = heavy_pass(m_renderer->pass_times());
    if (!heavy || !is_over(*heavy, heavy_pass_milliseconds))
        return;
    m_heavy_pass = passes[*heavy].name;
    if (std::exchange(m_has_told_heavy_pass, true))
        return;
    m_messages.ask(
        fmt::format("Pass \"{}\" takes {:.1f} s per frame", m_heavy_pass, latest[*heavy] / 1000.0),
        heavy_pass_choices().choices, heavy_subject);
}

void Lab::forget_heavy_pass() {
    if (!std::exchange(m_heavy_pass, {}).empty())
        m_messages.withdraw(heavy_subject);
}

ChoiceList Lab::heavy_pass_choices() const {
    const auto pass = m_document ? find_pass(m_document->look(), m_heavy_pass) : std::nullopt;
    return pass ? ::heavy_pass_choices(m_document->look().passes[static_cast<std::size_t>(*pass)],
                                       m_size.chosen())
                : ChoiceList{"Heavy pass"};
}
