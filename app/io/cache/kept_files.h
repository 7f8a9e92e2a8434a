#pragma once

#include "base/byte_store.h"

#include <cstdint>
#include <filesystem>
#include <mutex>

/// A ByteStore in a folder of the person's, one file an answer. What cannot be read, is cut short
/// or answers another question is as if it were not there, and replaced; what cannot be written is
/// found anew the next time.
class KeptFiles : public ByteStore {
public:
    /// `origin` says who answers: what another one has kept is not found. At most about
    /// `most_bytes` are kept; what has not been asked for longest goes first.
    KeptFiles(std::filesystem::path folder, std::string origin,
              std::uintmax_t most_bytes = std::uintmax_t{128} << 20);

    std::optional<std::string> find(std::string_view question) override;
    void keep(std::string_view question, std::string_view answer) override;

private:
    std::string whole(std::string_view question) const;
    std::filesystem::path file_of(std::string_view whole) const;
    bool write(const std::filesystem::path& file, std::string_view bytes) const;
    void make_room();

    std::filesystem::path m_folder;
    std::string m_origin;
    std::uintmax_t m_most_bytes;
    std::mutex m_mutex;
    std::uintmax_t m_unlooked_bytes;  // kept since the folder was last looked through
};
