#pragma once

#include "lab/media/chosen_images.h"
#include "lab/media/drive.h"
#include "lab/reload/look_loader.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What is open, for those who draw it with other values.
struct TrialSubject {
    const Document& document;
    const Player& player;
    Drive& drive;
    Renderer& shown;  // what the window shows; its programs are used, and to be claimed back
    const ImageTextures& images;
    Extent picture;  // that is to be drawn
};

/// Why a parameter that is a constant is not tried out.
std::string why_untried(const Parameter& constant);

/// The frames that were shown last, drawn anew with other values and in slices of a turn, beside
/// the picture: its history and its clock go on undisturbed.
class Trial {
public:
    /// Prepares a drawing of the latest `frames` frames. With `others` a second one goes along, of
    /// the same frames with those values. Fails where there is no memory.
    static Result<Trial> make(const TrialSubject& subject, const Values& values,
                              const Values* others, std::size_t frames);

    /// Begins anew with other values; the frames are the same.
    Result<void> start_again(const Values& values);
    /// Goes on for about `seconds`; true when it has just ended.
    bool go_on(const TrialSubject& subject, double seconds);

    bool is_running() const { return m_done < m_frames.size() || !has_samples(); }
    std::size_t done() const { return m_done; }
    std::size_t total() const { return m_frames.size(); }
    const Executor& executor() const { return m_renderer->executor(); }
    /// Of the values that go along; null without.
    const Executor* others() const { return m_renderer->variant(); }

private:
    Trial(std::unique_ptr<Renderer> renderer, std::vector<PlayedFrame> frames)
        : m_renderer(std::move(renderer)), m_frames(std::move(frames)) {}
    Result<void> show_pictures(const TrialSubject& subject, const Values& values,
                               const Values* others);
    void draw_next(const TrialSubject& subject);
    bool has_samples() const;

    std::unique_ptr<Renderer> m_renderer;
    ChosenImages m_chosen_images;
    ChosenImages m_other_images;
    SharedPicture m_source;
    std::vector<PlayedFrame> m_frames;
    std::size_t m_done = 0;
};

/// How many frames of a look can be drawn anew in about that time, at most as many as it takes to
/// settle, when each is drawn `times` times.
std::size_t bearable_frames(const Look& look, const Renderer& shown, double seconds, double times);
