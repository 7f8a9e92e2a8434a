#pragma once

#include "base/byte_store.h"

#include <map>
#include <memory>
#include <mutex>

/// A write-behind cache in front of another ByteStore. Entries are written to it by write_owed(),
/// so that keep() does not wait for files.
class KeptLater : public ByteStore {
public:
    explicit KeptLater(std::shared_ptr<ByteStore> store) : m_store(std::move(store)) {}

    std::optional<std::string> find(std::string_view question) override;
    void keep(std::string_view question, std::string_view answer) override;
    void write_owed();

private:
    std::shared_ptr<ByteStore> m_store;
    std::mutex m_mutex;
    std::map<std::string, std::string, std::less<>> m_owed;  // values by key
};
