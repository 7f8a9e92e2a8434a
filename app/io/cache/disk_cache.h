#pragma once

#include "base/byte_store.h"

#include <cstdint>
#include <filesystem>
#include <mutex>

/// A ByteStore in a folder, one file per entry. An entry that can't be read, is truncated or has
/// another key counts as missing and is replaced. Write errors are ignored.
class DiskCache : public ByteStore {
public:
    /// `origin` is part of each key: entries of other origins are not found. Keeps about
    /// `max_bytes` at most; the least recently used entries are removed first.
    DiskCache(std::filesystem::path folder, std::string origin,
              std::uintmax_t max_bytes = std::uintmax_t{128} << 20);

    std::optional<std::string> find(std::string_view key) override;
    void keep(std::string_view key, std::string_view value) override;

private:
    std::string whole(std::string_view key) const;
    std::filesystem::path file_of(std::string_view whole) const;
    bool write(const std::filesystem::path& file, std::string_view bytes) const;
    void evict();

    std::filesystem::path m_folder;
    std::string m_origin;
    std::uintmax_t m_max_bytes;
    std::mutex m_mutex;
    std::uintmax_t m_unscanned_bytes;  // written since the folder was last scanned
};
