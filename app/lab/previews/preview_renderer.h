#pragma once

#include "lab/media/chosen_images.h"
#include "lab/media/media_input.h"
#include "lab/reload/look_loader.h"
#include "lab/rendering/renderer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The open document and its renderer, as input of a preview.
struct PreviewSubject {
    const Document& document;
    const Player& player;
    MediaInput& media;
    const Renderer& shown;  // the window's renderer, whose programs are used
    const ImageTextures& images;
    Extent picture;  // size to draw
};

/// Why a constant cannot be previewed.
std::string preview_error(const Parameter& constant);

/// Redraws the latest frames with other values, one slice per update. It does not affect the
/// history or the clock of the picture.
class PreviewRenderer {
public:
    /// Prepares the latest `frames` frames. With `others` they are also drawn with those values.
    /// Fails without memory.
    static Result<PreviewRenderer> make(const PreviewSubject& subject, const Values& values,
                                        const Values* others, std::size_t frames);

    /// Restarts with other values and the same frames.
    Result<void> start_again(const Values& values);
    /// Draws for about `seconds`; true when it has just finished.
    bool update(const PreviewSubject& subject, double seconds);

    bool is_running() const { return m_done < m_frames.size() || !has_samples(); }
    std::size_t done() const { return m_done; }
    std::size_t total() const { return m_frames.size(); }
    const Executor& executor() const { return m_executors.picture(); }
    /// The executor for `others`; null: not used.
    const Executor* others() const { return m_executors.variant(); }

private:
    PreviewRenderer(Executors executors, std::vector<PlayedFrame> frames)
        : m_executors(std::move(executors)), m_frames(std::move(frames)) {}
    Result<void> show_pictures(const PreviewSubject& subject, const Values& values,
                               const Values* others);
    void draw_next(const PreviewSubject& subject);
    bool has_samples() const;

    Executors m_executors;
    Values m_values;  // without modulation
    Values m_other_values;
    ChosenImages m_chosen_images;
    ChosenImages m_other_images;
    SharedPicture m_source;
    std::vector<PlayedFrame> m_frames;
    std::size_t m_done = 0;
};

/// The number of frames that can be redrawn in about this time if each is drawn `times` times. At
/// most the settling time of the look.
std::size_t affordable_frames(const Look& look, const Renderer& shown, double seconds,
                              double times);
