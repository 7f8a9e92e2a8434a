#include "io/cache/disk_cache.h"

#include "base/file.h"
#include "base/packed.h"
#include "base/text.h"
#include "io/files/temporary_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view kept_format = "afterglow-kept 1";
constexpr std::string_view kept_extension = ".kept";
constexpr std::size_t max_answer_bytes = std::size_t{32} << 20;

// The folder is scanned after this number of new bytes.
std::uintmax_t scan_interval_bytes(std::uintmax_t max_bytes) {
    return max_bytes / 16;
}
}  // namespace

DiskCache::DiskCache(fs::path folder, std::string origin, std::uintmax_t max_bytes)
    : m_folder(std::move(folder)),
      m_origin(std::move(origin)),
      m_max_bytes(max_bytes),
      m_unscanned_bytes(scan_interval_bytes(max_bytes)) {}

std::string DiskCache::whole(std::string_view key) const {
    return fmt::format("{}\n{}", m_origin, key);
}

fs::path DiskCache::file_of(std::string_view whole) const {
    return m_folder / fmt::format("{:016x}{}", digest_of(whole), kept_extension);
}

std::optional<std::string> DiskCache::find(std::string_view key) {
    const std::string asked = whole(key);
    const fs::path file = file_of(asked);
    const auto bytes = read_bytes(file, max_answer_bytes);
    if (!bytes)
        return std::nullopt;
    Unpacker read(*bytes);
    const bool is_ours = read.text() == kept_format && read.text() == asked;
    const std::uint64_t digest = read.number();
    const std::string_view value = read.text();
    if (!is_ours || !read.is_at_end() || digest != digest_of(value))
        return std::nullopt;
    std::error_code error;
    fs::last_write_time(file, fs::file_time_type::clock::now(), error);
    return std::string(value);
}

void DiskCache::keep(std::string_view key, std::string_view value) {
    const std::string asked = whole(key);
    Packer packer;
    packer.add(kept_format);
    packer.add(asked);
    packer.add(digest_of(value));
    packer.add(value);
    const std::size_t size = packer.bytes().size();
    if (size > std::min<std::uintmax_t>(max_answer_bytes, m_max_bytes))
        return;
    if (!write(file_of(asked), packer.bytes()))
        return;  // not cached
    const std::scoped_lock lock(m_mutex);
    m_unscanned_bytes += size;
    if (m_unscanned_bytes >= scan_interval_bytes(m_max_bytes))
        evict();
}

// Not synced to disk: the digest detects a file that a crash has truncated.
bool DiskCache::write(const fs::path& file, std::string_view bytes) const {
    std::error_code error;
    fs::create_directories(m_folder, error);
    TemporaryFile written(m_folder);
    return written.is_open() && written.write(bytes) && written.replace_target(file);
}

void DiskCache::evict() {
    remove_leftovers(m_folder);
    struct Kept {
        fs::file_time_type used;
        std::uintmax_t bytes;
        fs::path file;
    };
    m_unscanned_bytes = 0;
    std::vector<Kept> all;
    std::uintmax_t sum = 0;
    std::error_code error;
    for (fs::directory_iterator it(m_folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->path().extension() != kept_extension)
            continue;
        std::error_code gone;
        const std::uintmax_t bytes = it->file_size(gone);
        const fs::file_time_type used = it->last_write_time(gone);
        if (gone)
            continue;  // removed by another program
        all.push_back({used, bytes, it->path()});
        sum += bytes;
    }
    std::ranges::sort(all, {}, &Kept::used);
    for (const Kept& oldest : all) {
        if (sum <= m_max_bytes)
            break;
        fs::remove(oldest.file, error);
        sum -= oldest.bytes;
    }
}
