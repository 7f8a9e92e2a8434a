#include "lab/playback/signal_file.h"

#include "base/text.h"
#include "formats/scene/scene_file.h"
#include "formats/svg/svg_file.h"
#include "io/sound/sound_file.h"
#include "lab/storage/media.h"

Result<SignalMedia> load_signal_media(const std::filesystem::path& file, JobProgress* work,
                                      Diagnostics* notes) {
    SignalMedia media;
    if (is_svg_file(file)) {
        auto drawing = load_svg_drawing(file);
        if (!drawing)
            return fail(drawing.error());
        media.drawing = std::make_shared<const Drawing>(std::move(*drawing));
        return media;
    }
    if (is_drawing_or_scene(file)) {
        auto scene = load_scene(file);
        if (!scene)
            return fail(scene.error());
        media.scene = std::make_shared<const BeamScene>(std::move(*scene));
        return media;
    }
    auto sound = load_sound(file, work, notes);
    if (!sound && is_sound_file(file))
        return fail(sound.error());
    if (!sound) {  // a sound is only one of the possible types
        Diagnostics reasons = sound.error();
        for (Diagnostic& reason : reasons)
            reason.message = with_sentence(
                reason.message,
                "Signals can use a sound, an SVG, a scene (.json) or a model (.obj).");
        return fail(std::move(reasons));
    }
    media.sound = std::make_shared<const Sound>(std::move(*sound));
    return media;
}
