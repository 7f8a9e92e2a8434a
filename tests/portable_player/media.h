#pragma once

#include "portable_player/textures.h"
#include "portable_player/values.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

/// All textures that are not targets: the source, images, keyboard and sound.
class Media {
public:
    Media(const Description& description, const Size& view);

    /// Shows the source at the end of a frame.
    void advance(double seconds);

    /// Null if there is no picture, such as the source of an earlier frame that was not drawn.
    const Texture* find(const Input& input) const;
    /// The picture that a parameter of a sampler chooses.
    const Texture* find_image(const std::string& name) const;
    /// 1 x 1 transparent black for a type of sampler; null for cubes and volumes.
    const Texture* empty(GLenum sampler) const;

    /// Null if the look has no source.
    const PlacedPicture* shown() const { return m_shown ? &*m_shown : nullptr; }
    Size source_size() const;

private:
    void load_chosen_images();
    void load_image(const Image& image);
    void add_image(const Image& image, Picture picture);
    void add_rows(const std::string& key, int columns, const std::vector<float>& rows, float alpha);
    void add_silence(const Input& input);
    void show(int number);

    const Description& m_description;
    Size m_view;
    std::optional<Source> m_source;
    int m_number = -1;  // of the shown picture
    std::optional<PlacedPicture> m_shown;
    std::shared_ptr<const Texture> m_newest;
    std::deque<std::shared_ptr<const Texture>> m_history;  // newest first
    std::map<std::string, std::shared_ptr<const Texture>> m_images;
    std::map<std::string, Texture> m_made;  // keyboard and silent sounds
    std::map<GLenum, Canvas> m_empty;       // by the type of the sampler
};
