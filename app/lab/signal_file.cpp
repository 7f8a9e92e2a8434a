#include "lab/signal_file.h"

#include "formats/scene_file.h"
#include "formats/svg_file.h"
#include "io/sound_file.h"

Result<SignalMedia> load_signal_media(const std::filesystem::path& file, Work* work,
                                      Diagnostics* notes) {
    SignalMedia media;
    if (is_svg_file(file)) {
        auto drawing = load_svg_drawing(file);
        if (!drawing)
            return fail(drawing.error());
        media.drawing = std::make_shared<const Drawing>(std::move(*drawing));
        return media;
    }
    if (is_drawn_file(file)) {
        auto scene = load_scene(file);
        if (!scene)
            return fail(scene.error());
        media.scene = std::make_shared<const BeamScene>(std::move(*scene));
        return media;
    }
    auto sound = load_sound(file, work, notes);
    if (!sound)
        return fail(sound.error());
    media.sound = std::make_shared<const Sound>(std::move(*sound));
    return media;
}
