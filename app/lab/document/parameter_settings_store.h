#pragma once

#include "lab/document/document.h"
#include "lab/messages/messages.h"
#include "model/tuning/parameter_settings.h"

/// What the user set about the parameters of all looks: favourites, locks, slider ranges.
class ParameterSettingsStore {
public:
    ParameterSettingsStore(OpenDocument& document, Messages& messages)
        : m_document(document), m_messages(messages) {}

    /// The settings of all looks, including changes in the open one.
    LookParameterSettings all() const;
    void set_all(LookParameterSettings settings);
    /// Stores the settings of the open look before it closes.
    void store() { m_stored = all(); }
    /// Gives the open look its stored settings.
    void load();
    /// Sets the range of a slider; nullopt: the range of the look.
    void set_slider_ends(const std::string& parameter, const std::optional<Limit>& ends);

private:
    OpenDocument& m_document;
    Messages& m_messages;
    LookParameterSettings m_stored;
};
