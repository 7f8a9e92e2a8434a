#include "io/files/zip.h"

#include "io/files/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
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

bool add(zip_t* archive, const fs::path& folder, const fs::path& file) {
    constexpr time_t date = 946684800;  // 2000-01-01
    zip_source_t* source = zip_source_file(archive, (folder / file).c_str(), 0, -1);
    const zip_int64_t index =
        source ? zip_file_add(archive, file.generic_string().c_str(), source, ZIP_FL_ENC_UTF_8)
               : -1;
    if (index < 0 && source)
        zip_source_free(source);
    return index >= 0 &&
           zip_file_set_mtime(archive, static_cast<zip_uint64_t>(index), date, 0) == 0;
}

struct Close {
    void operator()(zip_t* archive) const { zip_discard(archive); }
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

Result<std::string> content_of(zip_t* archive, zip_uint64_t index, const fs::path& zip) {
    const std::unique_ptr<zip_file_t, Close> file(zip_fopen_index(archive, index, 0));
    std::string content;
    std::vector<char> piece(1 << 16);
    zip_int64_t got = file ? 1 : -1;
    while (got > 0) {
        got = zip_fread(file.get(), piece.data(), piece.size());
        if (got > 0)
            content.append(piece.data(), static_cast<std::size_t>(got));
    }
    if (got < 0)
        return fail({zip, 0, "is damaged"});
    return content;
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

Result<void> unzip(const fs::path& zip, const fs::path& folder) {
    int code = 0;
    const std::unique_ptr<zip_t, Close> archive(zip_open(zip.c_str(), ZIP_RDONLY, &code));
    if (!archive)
        return fail({zip, 0, fmt::format("can't open: {}", text_of(code))});
    const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(archive.get(), 0));
    for (zip_uint64_t i = 0; i < count; ++i) {
        const fs::path name = zip_get_name(archive.get(), i, 0);
        const fs::path inside = name.lexically_normal();
        if (name.is_absolute() || inside.empty() || *inside.begin() == "..")
            return fail({zip, 0, fmt::format("contains a path outside: {}", name.string())});
        auto content = content_of(archive.get(), i, zip);
        if (!content)
            return fail(content.error());
        if (auto written = write_atomically(folder / inside, *content); !written)
            return fail(written.error());
    }
    return {};
}
