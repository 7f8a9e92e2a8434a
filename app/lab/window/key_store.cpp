#include "lab/window/key_store.h"

#include "base/file.h"
#include "io/files/atomic_file.h"

#include <algorithm>

KeyStore::KeyStore(const Roots& roots)
    : m_file(roots.config.empty() ? std::filesystem::path() : roots.config / "keys.json") {}

KeyBindings KeyStore::load(std::span<const KeyedAction> actions, Diagnostics& problems) {
    std::error_code error;
    if (m_file.empty() || !std::filesystem::exists(m_file, error))
        return {};
    const auto text = read_text(m_file);
    const auto choices = text ? parse_keys(*text, m_file) : fail(text.error());
    if (!choices) {
        m_is_broken = true;
        problems.insert(problems.end(), choices.error().begin(), choices.error().end());
        return {};
    }
    m_saved = bindings_from(*choices, actions, m_file, problems);
    std::ranges::copy_if(*choices, std::back_inserter(m_unknown), [&](const KeyChoice& choice) {
        return std::ranges::find(actions, choice.action, &KeyedAction::name) == actions.end();
    });
    return m_saved;
}

void KeyStore::update(const KeyBindings& bindings, Messages& messages) {
    if (m_file.empty() || bindings == m_saved)
        return;
    m_saved = bindings;
    if (m_is_broken)
        return messages.say({m_file, 0,
                             "has errors and was not overwritten. Correct or delete it; "
                             "until then, changed keys are lost at the end."});
    std::vector<KeyChoice> choices = bindings.choices();
    choices.insert(choices.end(), m_unknown.begin(), m_unknown.end());
    std::error_code error;
    std::filesystem::create_directories(m_file.parent_path(), error);
    messages.succeeded(write_atomically(m_file, keys_to_json(choices)));
}
