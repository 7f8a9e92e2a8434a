#include "lab/compare/reference_picture.h"

#include "io/pictures/picture_file.h"

#include <utility>

Result<void> ReferencePicture::read(const std::filesystem::path& file) {
    if (std::exchange(m_file, file) != file)
        m_picture.reset();
    auto picture = load_picture(file);
    if (!picture)
        return fail(std::move(picture.error()));
    m_picture = std::make_shared<const Picture>(std::move(*picture));
    return {};
}
