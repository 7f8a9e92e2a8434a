#include "lab/document/automation.h"

#include "io/files/atomic_file.h"
#include "lab/document/automation_file.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

void Automation::record(bool is_recording) {
    if (!is_recording || !m_document)
        return m_recorder.stop();
    m_recorder.start(m_document->look(), m_document->values());
    m_messages.say("Recording automation");
}

void Automation::save(const fs::path& given) {
    const fs::path file = given.has_extension() ? given : fs::path(given.string() + ".txt");
    if (!m_messages.succeeded(
            write_atomically(file, automation_text(m_recorder.points(), m_recorder.look()))))
        return;
    const std::string name = file.filename().string();
    const std::size_t count = m_recorder.points().size();
    m_messages.say(count == 1 ? fmt::format("Saved 1 parameter change to \"{}\"", name)
                              : fmt::format("Saved {} parameter changes to \"{}\"", count, name));
}

void Automation::update(double seconds) {
    if (!m_document || !m_recorder.is_running() || m_document->has_pending_stack())
        return;
    if (m_document->look().id == m_recorder.look().id)
        return m_recorder.note(m_document->values(), seconds);
    m_recorder.stop();
    m_messages.say(
        "Recording stopped because another look was opened. You can still save the automation.");
}
