#include "io/pictures/picture_sequence.h"

#include "base/text.h"
#include "io/pictures/picture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace fs = std::filesystem;

namespace {
constexpr std::size_t max_digits = 9;

// "frame_%04d.png": the text before and after the number, and the minimum number of digits.
struct Name {
    std::string before;
    std::string after;
    std::size_t digits = 1;
};

std::optional<Name> parse_name(const std::string& text) {
    const std::size_t percent = text.find('%');
    const std::size_t end = text.find('d', percent == std::string::npos ? 0 : percent);
    if (percent == std::string::npos || end == std::string::npos ||
        text.find('%', percent + 1) != std::string::npos)
        return std::nullopt;
    const std::string width = text.substr(percent + 1, end - percent - 1);
    const auto digits = width.empty() ? std::optional<int>(1) : parse_integer(width);
    if (!digits || *digits < 1 || *digits > static_cast<int>(max_digits))
        return std::nullopt;
    return Name{text.substr(0, percent), text.substr(end + 1), static_cast<std::size_t>(*digits)};
}

bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

// The number in a file name as printf formats it: zeros only up to the width.
std::optional<int> number_of(const std::string& file, const Name& name) {
    if (!file.starts_with(name.before) || !file.ends_with(name.after) ||
        file.size() <= name.before.size() + name.after.size())
        return std::nullopt;
    const std::string number =
        file.substr(name.before.size(), file.size() - name.before.size() - name.after.size());
    const bool has_width =
        number.size() == name.digits || (number.size() > name.digits && number.front() != '0');
    if (!has_width || number.size() > max_digits || !std::ranges::all_of(number, is_digit))
        return std::nullopt;
    return parse_integer(number);
}

class PictureSequence : public PictureReader {
public:
    PictureSequence(fs::path name, std::map<int, fs::path> files)
        : m_name(std::move(name)), m_files(std::move(files)) {}

    Result<std::optional<Picture>> read(std::int64_t number) override {
        if (number < 0 || number >= *count())
            return std::nullopt;
        const int asked = m_files.begin()->first + static_cast<int>(number);
        const auto file = m_files.find(asked);
        if (file == m_files.end())
            return fail({m_name, 0,
                         fmt::format("picture {} is missing. The sequence has {} pictures, "
                                     "numbered {} to {}.",
                                     asked, m_files.size(), m_files.begin()->first,
                                     m_files.rbegin()->first)});
        auto picture = load_picture(file->second);
        if (!picture)
            return fail(picture.error());
        if (!m_extent.is_empty() && picture->extent != m_extent)
            return fail({file->second, 0,
                         fmt::format("expected {} x {} px like the start of the sequence, got {} "
                                     "x {} px",
                                     m_extent.width, m_extent.height, picture->extent.width,
                                     picture->extent.height)});
        m_extent = picture->extent;
        return std::optional(std::move(*picture));
    }

    std::optional<std::int64_t> count() const override {
        return std::int64_t{m_files.rbegin()->first} - m_files.begin()->first + 1;
    }

private:
    fs::path m_name;
    std::map<int, fs::path> m_files;  // by number
    Extent m_extent;                  // of the first picture read
};
}  // namespace

bool is_sequence_name(const fs::path& name) {
    return parse_name(name.filename().string()).has_value();
}

Result<std::unique_ptr<PictureReader>> open_sequence(const fs::path& name) {
    const auto parts = parse_name(name.filename().string());
    if (!parts)
        return fail({name, 0, "the name of a sequence must contain one number, such as %04d"});
    std::map<int, fs::path> files;
    const fs::path folder = name.parent_path().empty() ? fs::path(".") : name.parent_path();
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (const auto number = number_of(entry->path().filename().string(), *parts))
            files.emplace(*number, entry->path());
    if (files.empty())
        return fail({name, 0, "no numbered pictures match this name"});
    return std::make_unique<PictureSequence>(name, std::move(files));
}
