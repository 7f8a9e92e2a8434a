#include "lab/window/key_store.h"

#include "base/file.h"
#include "io/files/atomic_file.h"

#include <algorithm>
#include <utility>

KeyStore::KeyStore(const Roots& roots)
    : m_file(roots.config.empty() ? std::filesystem::path() : roots.config / "keys.json") {}

KeyBindings KeyStore::load(std::span<const KeyedAction> actions, Diagnostics& problems) {
    if (m_file.empty())
        return {};
    const auto choices = read();
    if (!choices) {
        problems.insert(problems.end(), choices.error().begin(), choices.error().end());
        return {};
    }
    m_saved = bindings_from(*choices, actions, m_file, problems);
    return m_saved;
}

namespace {
// The choices of the file with those that differ between two states. Another window may have
// changed the file, and a newer program may have added actions.
std::vector<KeyChoice> merged(std::vector<KeyChoice> stored, const std::vector<KeyChoice>& before,
                              const std::vector<KeyChoice>& now) {
    const auto forget = [&](const KeyChoice& choice) {
        std::erase_if(stored, [&](const KeyChoice& old) { return old.action == choice.action; });
    };
    for (const KeyChoice& choice : before)
        if (std::ranges::find(now, choice) == now.end())
            forget(choice);
    for (const KeyChoice& choice : now)
        if (std::ranges::find(before, choice) == before.end()) {
            forget(choice);
            stored.push_back(choice);
        }
    return stored;
}
}  // namespace

Result<std::vector<KeyChoice>> KeyStore::read() const {
    std::error_code error;
    if (!std::filesystem::exists(m_file, error))
        return std::vector<KeyChoice>();
    const auto text = read_text(m_file);
    return text ? parse_keys(*text, m_file) : fail(text.error());
}

void KeyStore::update(const KeyBindings& bindings, Messages& messages) {
    if (m_file.empty() || bindings == m_saved)
        return;
    const KeyBindings before = std::exchange(m_saved, bindings);
    const auto stored = read();
    if (!stored)
        return messages.say(
            {m_file, 0, "has errors, so changed keys are not saved. Correct or delete the file."});
    std::error_code error;
    std::filesystem::create_directories(m_file.parent_path(), error);
    messages.succeeded(write_atomically(
        m_file, keys_to_json(merged(*stored, before.choices(), bindings.choices()))));
}
