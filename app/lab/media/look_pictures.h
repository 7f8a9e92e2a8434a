#pragma once

#include "graph/warm_up/first_draws.h"
#include "lab/media/chosen_images.h"
#include "lab/rendering/executors.h"

#include <filesystem>
#include <vector>

/// The pictures of a look's samplers: images that the look names, and files that the user chose,
/// for the picture and for the variant that it is compared with.
class LookPictures {
public:
    /// Uploads the images of the look that changed.
    void show_look_images(const ImageTextures& images, Executors& executors);
    const ImageTextures& look_images() const { return m_look_images; }
    /// Uploads the chosen files that changed.
    Result<void> show_chosen(const Look& look, const Values& values, Executors& executors);
    /// The same for the variant; without effect while there is none.
    Result<void> show_variant(const Look& look, const Values& values, Executors& executors);
    /// All pictures, for a variant that has none yet.
    Result<void> show_new_variant(const Look& look, const Values& values, Executors& executors);

    /// The files that the user chose, being read and read.
    ChosenImages& chosen() { return m_chosen; }
    const ChosenImages& chosen() const { return m_chosen; }
    /// Another look, or one that reads its images otherwise.
    void clear();
    void clear_variant() { m_variant.forget(); }
    /// Marks a file as changed; true if a sampler uses it.
    bool forget(const std::filesystem::path& file);
    std::vector<std::filesystem::path> files() const;

private:
    ImageTextures m_look_images;
    ChosenImages m_chosen;
    ChosenImages m_variant;
};
