#include "io/cache/kept_later.h"

#include <utility>

std::optional<std::string> KeptLater::find(std::string_view question) {
    {
        const std::scoped_lock lock(m_mutex);
        if (const auto owed = m_owed.find(question); owed != m_owed.end())
            return owed->second;
    }
    return m_store->find(question);
}

void KeptLater::keep(std::string_view question, std::string_view answer) {
    const std::scoped_lock lock(m_mutex);
    m_owed.insert_or_assign(std::string(question), std::string(answer));
}

// An entry stays readable here until it is in the store.
void KeptLater::write_owed() {
    std::unique_lock lock(m_mutex);
    while (!m_owed.empty()) {
        const auto first = *m_owed.begin();
        lock.unlock();
        m_store->keep(first.first, first.second);
        lock.lock();
        if (const auto owed = m_owed.find(first.first);
            owed != m_owed.end() && owed->second == first.second)
            m_owed.erase(owed);
    }
}
