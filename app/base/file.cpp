#include "base/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace fs = std::filesystem;

namespace {
Result<std::size_t> size_of(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status))
        return fail({file, 0, "file not found"});
    if (!fs::is_regular_file(status))
        return fail(
            {file, 0,
             fs::is_directory(status) ? "this is a folder, not a file" : "this is not a file"});
    const std::uintmax_t size = fs::file_size(file, error);
    if (error)
        return fail({file, 0, error.message()});
    return static_cast<std::size_t>(size);
}

Result<std::string> read_so_many(const fs::path& file, std::size_t count) {
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(count, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream && !stream.eof())
        return fail({file, 0, fmt::format("can't read the file: {}", std::strerror(errno))});
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}
}  // namespace

Result<std::string> read_bytes(const fs::path& file, std::size_t max_bytes) {
    const auto size = size_of(file);
    if (!size)
        return fail(size.error());
    if (*size > max_bytes)
        return fail(
            {file, 0,
             fmt::format("the file is too large: {} bytes; the limit is {}", *size, max_bytes)});
    return read_so_many(file, *size);
}

Result<std::string> read_start(const fs::path& file, std::size_t count) {
    const auto size = size_of(file);
    if (!size)
        return fail(size.error());
    return read_so_many(file, std::min(*size, count));
}

Result<std::string> read_text(const fs::path& file) {
    constexpr std::size_t max_bytes = std::size_t{16} << 20;
    auto text = read_bytes(file, max_bytes);
    if (!text)
        return text;
    if (text->starts_with("\xef\xbb\xbf"))
        text->erase(0, 3);
    const std::size_t zero = text->find('\0');
    if (zero != std::string::npos) {
        const auto line =
            std::count(text->begin(), text->begin() + static_cast<std::ptrdiff_t>(zero), '\n');
        return fail(
            {file, static_cast<int>(line) + 1, "this is not a text file: it contains a NUL byte"});
    }
    return text;
}

bool is_inside(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (error)
        return false;
    const fs::path root = fs::canonical(folder, error);
    if (error)
        return false;
    const auto [end, _] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
    return end == root.end();
}
