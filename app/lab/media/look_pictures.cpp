#include "lab/media/look_pictures.h"

namespace fs = std::filesystem;

void LookPictures::show_look_images(const ImageTextures& images, Executors& executors) {
    for (const auto& [name, texture] : images)
        if (const auto shown = m_look_images.find(name);
            shown == m_look_images.end() || shown->second != texture)
            executors.set_image(name, texture);
    m_look_images = images;
}

Result<void> LookPictures::show_chosen(const Look& look, const Values& values,
                                       Executors& executors) {
    return m_chosen.show(look, values, executors.picture(), ChosenImages::Reading::in_background);
}

Result<void> LookPictures::show_variant(const Look& look, const Values& values,
                                        Executors& executors) {
    if (!executors.variant())
        return {};
    return m_variant.show(look, values, *executors.variant());
}

Result<void> LookPictures::show_new_variant(const Look& look, const Values& values,
                                            Executors& executors) {
    for (const auto& [name, texture] : m_look_images)
        executors.set_image(name, texture);
    m_variant.forget();
    return show_variant(look, values, executors);
}

void LookPictures::clear() {
    m_look_images.clear();
    m_chosen.forget();
    m_variant.forget();
}

bool LookPictures::forget(const fs::path& file) {
    const bool is_chosen = m_chosen.forget(file);
    return m_variant.forget(file) || is_chosen;
}

std::vector<fs::path> LookPictures::files() const {
    std::vector<fs::path> files = m_chosen.files();
    for (const fs::path& file : m_variant.files())
        files.push_back(file);
    return files;
}
