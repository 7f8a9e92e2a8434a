#include "portable_player/media.h"

#include "portable_player/error.h"

#include <algorithm>

namespace {
constexpr std::size_t longest_history = 65;

Shape shape_named(const std::string& name) {
    return name == "cube" ? Shape::cube : name == "volume" ? Shape::volume : Shape::flat;
}

bool is_read_with_levels(const Description& description, const std::string& from,
                         const std::string& name) {
    for (const Pass& pass : description.passes)
        for (const Input& input : pass.inputs)
            if (input.from == from && input.name == name && input.sampler.is_mipmapped)
                return true;
    return false;
}

std::string sound_key(const Input& input) {
    return input.holds + " " + std::to_string(input.columns);
}

Picture single_pixel(float alpha) {
    Picture picture = new_picture(1, 1, false);
    picture.pixels[3] = alpha;
    return picture;
}
}  // namespace

Media::Media(const Description& description, const Size& view)
    : m_description(description), m_view(view) {
    constexpr Size pixel{1, 1};
    m_empty.emplace(GL_SAMPLER_2D, Canvas(pixel, "rgba8", false));
    m_empty.emplace(GL_INT_SAMPLER_2D, Canvas(pixel, "r32i", false));
    m_empty.emplace(GL_UNSIGNED_INT_SAMPLER_2D, Canvas(pixel, "r32ui", false));
    if (description.driven_by == "picture" && description.source) {
        m_source.emplace(description, view);
        show(m_source->number_at(0.0));
    }
    for (const Image& image : description.images)
        load_image(image);
    load_chosen_images();
    constexpr int keys = 256;
    add_rows("keyboard", keys, {0.0F, 0.0F, 0.0F}, 0.0F);
    for (const Pass& pass : description.passes)
        for (const Input& input : pass.inputs)
            if (input.from == "sound")
                add_silence(input);
}

void Media::load_image(const Image& image) {
    if (image.files.empty() && image.generated.empty())
        return;  // a parameter chooses it
    if (image.files.empty())
        throw Error("has the image '" + image.generated + "', which only Afterglow can draw");
    std::vector<Picture> pictures;
    try {
        for (const std::filesystem::path& file : image.files)
            pictures.push_back(load_picture(file));
        add_image(image, solid_of(pictures, image.shape));
    } catch (const Error& error) {
        if (image.is_needed)
            throw Error(image.files.front().string() + ": " + error.what());
        add_image(image, single_pixel(1.0F));
    }
}

// Images that parameters choose. Those of cubes and volumes are also in the list of images.
void Media::load_chosen_images() {
    for (const Parameter& parameter : m_description.parameters) {
        if (parameter.type != "image")
            continue;
        Image image;
        image.name = parameter.name;
        for (const Image& listed : m_description.images)
            if (listed.name == parameter.name)
                image = listed;
        if (parameter.text.empty()) {
            add_image(image, single_pixel(1.0F));
            continue;
        }
        image.generated = parameter.text;
        if (parameter.text.find(':') == std::string::npos)
            image.files = {file_in(m_description.folder, parameter.text)};
        load_image(image);
    }
}

void Media::add_image(const Image& image, Picture picture) {
    if (!image.is_data)
        recode(picture, image.is_display.value_or(m_description.reads_display));
    const Shape shape = shape_named(image.shape);
    const Size size{picture.width, shape == Shape::flat ? picture.height : picture.width};
    auto texture = std::make_shared<Texture>(
        shape, size, image.format, is_read_with_levels(m_description, "image", image.name));
    texture->upload(picture, image.is_top_first);
    texture->generate_mipmaps();
    m_images[image.name] = std::move(texture);
}

void Media::add_rows(const std::string& key, int columns, const std::vector<float>& rows,
                     float alpha) {
    Picture picture = new_picture(columns, static_cast<int>(rows.size()), false);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            std::fill_n(picture.pixel(x, y), 3, rows[static_cast<std::size_t>(y)]);
            picture.pixel(x, y)[3] = alpha;
        }
    Texture texture(Shape::flat, {picture.width, picture.height}, "rgba32f", false);
    texture.upload(picture, true);
    m_made.insert_or_assign(key, std::move(texture));
}

void Media::add_silence(const Input& input) {
    if (m_description.driven_by == "signal")
        throw Error("reads its signal as a sound, which this player doesn't support");
    constexpr float no_wave = 0.5F;
    const float first = input.holds == "wave" ? no_wave : 0.0F;
    const float second = input.holds == "spectrum" ? 0.0F : no_wave;
    add_rows(sound_key(input), input.columns, {first, second}, 1.0F);
}

void Media::show(int number) {
    const SourcePicture& source = *m_description.source;
    m_number = number;
    m_shown = m_source->placed(number);
    Picture& picture = m_shown->picture;
    recode(picture, m_description.reads_display);
    const bool is_mipmapped = is_read_with_levels(m_description, "source", "");
    auto texture = std::make_shared<Texture>(Shape::flat, Size{picture.width, picture.height},
                                             source.format, is_mipmapped);
    texture->upload(picture, source.is_top_first);
    texture->generate_mipmaps();
    m_newest = std::move(texture);
}

void Media::advance(double seconds) {
    if (!m_source)
        return;
    if (const int number = m_source->number_at(seconds); number != m_number)
        show(number);
    m_history.push_front(m_newest);
    if (m_history.size() > longest_history)
        m_history.pop_back();
}

const Texture* Media::find(const Input& input) const {
    if (input.from == "image")
        return find_image(input.name);
    if (input.from == "source") {
        const auto ago = static_cast<std::size_t>(input.frames_ago);
        return ago < m_history.size() ? m_history[ago].get() : nullptr;
    }
    const auto found = m_made.find(input.from == "keyboard" ? input.from : sound_key(input));
    return found == m_made.end() ? nullptr : &found->second;
}

const Texture* Media::find_image(const std::string& name) const {
    const auto found = m_images.find(name);
    return found == m_images.end() ? nullptr : found->second.get();
}

const Texture* Media::empty(GLenum sampler) const {
    const auto found = m_empty.find(sampler);
    return found == m_empty.end() ? nullptr : &found->second.texture();
}

Size Media::source_size() const {
    return m_shown ? Size{m_shown->picture.width, m_shown->picture.height} : m_view;
}
