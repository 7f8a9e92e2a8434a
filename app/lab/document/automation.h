#pragma once

#include "lab/document/document.h"
#include "lab/messages/messages.h"
#include "model/tuning/automation.h"

/// Records parameter changes over time, and writes them as an automation file.
class Automation {
public:
    Automation(const OpenDocument& document, Messages& messages)
        : m_document(document), m_messages(messages) {}

    const AutomationRecorder& recorder() const { return m_recorder; }
    void record(bool is_recording);
    void save(const std::filesystem::path& file);
    /// Records the values of a frame that was drawn at this time of the clock.
    void update(double seconds);

private:
    const OpenDocument& m_document;
    Messages& m_messages;
    AutomationRecorder m_recorder;
};
