#pragma once

#include "base/byte_store.h"

#include <map>
#include <memory>
#include <mutex>

/// A ByteStore in front of another one, to which answers go when write_owed() is called: whoever
/// waits for what an answer is needed for does not wait for a file to be written as well.
class KeptLater : public ByteStore {
public:
    /// `store` is not null.
    explicit KeptLater(std::shared_ptr<ByteStore> store) : m_store(std::move(store)) {}

    std::optional<std::string> find(std::string_view question) override;
    void keep(std::string_view question, std::string_view answer) override;
    void write_owed();

private:
    std::shared_ptr<ByteStore> m_store;
    std::mutex m_mutex;
    std::map<std::string, std::string, std::less<>> m_owed;  // answers by their questions
};
