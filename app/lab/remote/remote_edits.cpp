#include "lab/remote/remote_edits.h"

#include "lab/document/parameter_edits.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr double quiet_seconds = 0.5;
}

bool RemoteGesture::continues_step(const std::string& parameter, double now_seconds) {
    const auto last = m_touched.find(parameter);
    const bool continues_step =
        last != m_touched.end() && now_seconds - last->second < quiet_seconds;
    if (!continues_step)
        m_touched.erase(parameter);
    m_touched[parameter] = now_seconds;
    return continues_step;
}

bool RemoteGesture::has_ended(double now_seconds) {
    const bool is_quiet = std::ranges::all_of(m_touched, [&](const auto& touched) {
        return now_seconds - touched.second >= quiet_seconds;
    });
    if (m_touched.empty() || !is_quiet)
        return false;
    m_touched.clear();
    return true;
}

Result<void> RemoteEdits::apply(Document& document, const RemoteChange& change,
                                double now_seconds) {
    if (setting_of(change.parameter, document.parameter_settings()).is_locked)
        return fail({{}, 0, fmt::format("'{}' is locked", change.parameter)});
    if (!m_gesture.continues_step(change.parameter, now_seconds))
        document.finish();
    set_values(document, {{change.parameter, change.value}}, "Remote control", true);
    return {};
}

void RemoteEdits::update(Document* document, double now_seconds) {
    if (m_gesture.has_ended(now_seconds) && document)
        document->finish();
}
