#include "io/files/zip.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>
#include <zip.h>

namespace fs = std::filesystem;

namespace {
std::string text_of(int code) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    std::string text = zip_error_strerror(&error);
    zip_error_fini(&error);
    return text;
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path().lexically_relative(folder));
    std::ranges::sort(files);
    return files;
}

// Files that are compressed already, or whose compression would not be worth its ratio.
bool is_media(const fs::path& file) {
    constexpr std::array endings{".png",  ".jpg",  ".jpeg", ".webp", ".exr", ".hdr",
                                 ".wav",  ".flac", ".ogg",  ".oga",  ".mp3", ".aif",
                                 ".aiff", ".mp4",  ".mkv",  ".webm", ".mov", ".avi"};
    return std::ranges::find(endings, to_lower(file.extension().string())) != endings.end();
}

bool add(zip_t* archive, const fs::path& folder, const fs::path& file) {
    constexpr time_t date = 946684800;  // 2000-01-01
    zip_source_t* source = zip_source_file(archive, (folder / file).c_str(), 0, -1);
    const zip_int64_t index =
        source ? zip_file_add(archive, file.generic_string().c_str(), source, ZIP_FL_ENC_UTF_8)
               : -1;
    if (index < 0 && source)
        zip_source_free(source);
    if (index < 0)
        return false;
    const auto place = static_cast<zip_uint64_t>(index);
    return zip_file_set_mtime(archive, place, date, 0) == 0 &&
           (!is_media(file) || zip_set_file_compression(archive, place, ZIP_CM_STORE, 0) == 0);
}

struct Close {
    void operator()(zip_t* archive) const { zip_discard(archive); }
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// A file in an archive.
struct Entry {
    zip_uint64_t index = 0;
    fs::path path;
    std::uint64_t bytes = 0;   // unpacked
    std::uint64_t packed = 0;  // bytes in the archive
};

// Regular files, or files of a system that has no other kinds.
bool is_plain_file(zip_t* archive, zip_uint64_t index) {
    constexpr zip_uint32_t kind_mask = 0170000;
    constexpr zip_uint32_t regular_file = 0100000;
    zip_uint8_t system = ZIP_OPSYS_DOS;
    zip_uint32_t attributes = 0;
    zip_file_get_external_attributes(archive, index, 0, &system, &attributes);
    const zip_uint32_t kind = (attributes >> 16U) & kind_mask;
    return system != ZIP_OPSYS_UNIX || kind == 0 || kind == regular_file;
}

bool leads_outside(const std::string& name) {
    const fs::path path(name);
    const bool goes_up = std::ranges::find(path, fs::path("..")) != path.end();
    return name.empty() || path.is_absolute() || goes_up || name.find('\\') != name.npos ||
           name.find(':') != name.npos;
}

bool has_control_character(const std::string& name) {
    return std::ranges::any_of(name, [](char letter) {
        return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
    });
}

Diagnostic refused(const fs::path& zip, std::string_view why, const std::string& name) {
    return {zip, 0, fmt::format("{}: {}. Nothing was extracted.", why, name)};
}

// The file at an index; nullopt: a folder.
Result<std::optional<Entry>> read_entry(zip_t* archive, zip_uint64_t index, const fs::path& zip) {
    zip_stat_t stat;
    if (zip_stat_index(archive, index, 0, &stat) != 0 || (stat.valid & ZIP_STAT_NAME) == 0 ||
        (stat.valid & ZIP_STAT_SIZE) == 0 || (stat.valid & ZIP_STAT_COMP_SIZE) == 0)
        return fail({zip, 0, "is damaged"});
    const std::string name = stat.name;
    if (has_control_character(name))
        return fail({zip, 0, "contains a name with control characters. Nothing was extracted."});
    if (leads_outside(name))
        return fail(refused(zip, "contains a path outside", name));
    if (name.ends_with('/'))
        return std::nullopt;
    if (!is_plain_file(archive, index))
        return fail(refused(zip, "contains a link or special file", name));
    return Entry{index, fs::path(name).lexically_normal(), stat.size, stat.comp_size};
}

// Two paths that are one on a file system without case, or a file that is also a folder.
std::optional<std::string> doubled_path(const std::vector<Entry>& entries) {
    std::map<std::string, std::string> paths;  // as written, by lower case
    const auto collides = [&](const std::string& path) {
        return paths.emplace(to_lower(path), path).first->second != path;
    };
    std::set<std::string> files;
    for (const Entry& entry : entries) {
        const std::string path = entry.path.generic_string();
        if (!files.insert(path).second || collides(path))
            return path;
        for (fs::path folder = entry.path.parent_path(); !folder.empty();
             folder = folder.parent_path())
            if (collides(folder.generic_string()))
                return path;
    }
    for (const Entry& entry : entries)
        for (fs::path folder = entry.path.parent_path(); !folder.empty();
             folder = folder.parent_path())
            if (files.contains(folder.generic_string()))
                return folder.generic_string();
    return std::nullopt;
}

Result<void> check_sizes(const std::vector<Entry>& entries, const ZipLimits& limits,
                         const fs::path& zip) {
    std::uint64_t bytes = 0;
    std::uint64_t packed = 0;
    for (const Entry& entry : entries) {
        if (entry.bytes > limits.bytes - bytes)
            return fail({zip, 0,
                         fmt::format("contains more than {:.0f} MB. Nothing was extracted.",
                                     1e-6 * static_cast<double>(limits.bytes))});
        bytes += entry.bytes;
        packed += entry.packed;
    }
    if (static_cast<double>(bytes) > limits.ratio * static_cast<double>(packed))
        return fail({zip, 0,
                     fmt::format("would grow more than {:.0f} times. Nothing was extracted.",
                                 limits.ratio)});
    return {};
}

Result<std::vector<Entry>> checked_entries(zip_t* archive, const ZipLimits& limits,
                                           const fs::path& zip) {
    const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(archive, 0));
    if (count > limits.files)
        return fail({zip, 0,
                     fmt::format("contains {} files; at most {} are allowed. Nothing was "
                                 "extracted.",
                                 count, limits.files)});
    std::vector<Entry> entries;
    for (zip_uint64_t i = 0; i < count; ++i) {
        auto entry = read_entry(archive, i, zip);
        if (!entry)
            return fail(entry.error());
        if (*entry)
            entries.push_back(std::move(**entry));
    }
    if (const auto doubled = doubled_path(entries))
        return fail(
            refused(zip, "contains a name twice, or names that differ in case only", *doubled));
    if (auto good = check_sizes(entries, limits, zip); !good)
        return fail(good.error());
    return entries;
}

Result<void> extract(zip_t* archive, const Entry& entry, const fs::path& folder,
                     const fs::path& zip) {
    const fs::path target = folder / entry.path;
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    std::ofstream output(target, std::ios::binary | std::ios::trunc);
    const std::unique_ptr<zip_file_t, Close> file(zip_fopen_index(archive, entry.index, 0));
    if (!file)
        return fail(
            {zip, 0, fmt::format("can't read {}: {}", entry.path.string(), zip_strerror(archive))});
    std::vector<char> piece(1 << 16);
    std::uint64_t bytes = 0;
    for (;;) {
        const zip_int64_t got = zip_fread(file.get(), piece.data(), piece.size());
        if (got < 0 || (got == 0 && bytes != entry.bytes))
            return fail({zip, 0, fmt::format("is damaged at {}", entry.path.string())});
        if (got == 0)
            break;
        bytes += static_cast<std::uint64_t>(got);
        if (bytes > entry.bytes)
            return fail({zip, 0, fmt::format("is damaged at {}", entry.path.string())});
        output.write(piece.data(), got);
    }
    output.close();
    if (!output)
        return fail({target, 0, "can't be written. Check the free space."});
    return {};
}
}  // namespace

Result<void> zip_folder(const fs::path& folder, const fs::path& zip) {
    int code = 0;
    std::unique_ptr<zip_t, Close> archive(zip_open(zip.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (!archive)
        return fail({zip, 0, fmt::format("can't create: {}", text_of(code))});
    for (const fs::path& file : files_in(folder))
        if (!add(archive.get(), folder, file))
            return fail(
                {zip, 0,
                 fmt::format("can't add {}: {}", file.string(), zip_strerror(archive.get()))});
    if (zip_close(archive.get()) != 0)
        return fail({zip, 0, fmt::format("can't write: {}", zip_strerror(archive.get()))});
    (void)archive.release();  // NOLINT(bugprone-unused-return-value): zip_close() has freed it
    return {};
}

namespace {
using Archive = std::unique_ptr<zip_t, Close>;

Result<Archive> opened(const fs::path& zip) {
    int code = 0;
    Archive archive(zip_open(zip.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code));
    if (!archive)
        return fail({zip, 0, fmt::format("can't open: {}", text_of(code))});
    return archive;
}
}  // namespace

Result<void> check_zip(const fs::path& zip, const ZipLimits& limits) {
    const auto archive = opened(zip);
    if (!archive)
        return fail(archive.error());
    const auto entries = checked_entries(archive->get(), limits, zip);
    return entries ? Result<void>() : fail(entries.error());
}

Result<std::string> read_in_zip(const fs::path& zip, const std::string& path,
                                std::size_t max_bytes) {
    const auto archive = opened(zip);
    if (!archive)
        return fail(archive.error());
    const zip_int64_t index = zip_name_locate(archive->get(), path.c_str(), 0);
    zip_stat_t stat;
    if (index < 0)
        return std::string();
    const auto place = static_cast<zip_uint64_t>(index);
    if (zip_stat_index(archive->get(), place, 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0 ||
        stat.size > max_bytes)
        return fail({zip, 0, fmt::format("{} is damaged or too large", path)});
    std::string content(stat.size, '\0');
    const std::unique_ptr<zip_file_t, Close> file(zip_fopen_index(archive->get(), place, 0));
    if (!file || zip_fread(file.get(), content.data(), content.size()) !=
                     static_cast<zip_int64_t>(content.size()))
        return fail({zip, 0, fmt::format("{} is damaged", path)});
    return content;
}

Result<void> unzip(const fs::path& zip, const fs::path& folder, const ZipLimits& limits) {
    const auto archive = opened(zip);
    if (!archive)
        return fail(archive.error());
    const auto entries = checked_entries(archive->get(), limits, zip);
    if (!entries)
        return fail(entries.error());
    for (const Entry& entry : *entries)
        if (auto extracted = extract(archive->get(), entry, folder, zip); !extracted)
            return extracted;
    return {};
}
