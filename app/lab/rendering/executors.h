#pragma once

#include "graph/executor/executor.h"
#include "lab/rendering/frame_inputs.h"
#include "model/tuning/cue_plan.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

/// The executors of a look, and the inputs of their frames: the picture, and in a comparison a
/// variant, which is the same look and frames with other values.
class Executors {
public:
    explicit Executors(Executor picture) : m_picture(std::move(picture)) {}

    Executor& picture() { return m_picture; }
    const Executor& picture() const { return m_picture; }
    /// Null without a comparison, and after the variant has failed.
    Executor* variant() { return m_variant.get(); }
    const Executor* variant() const { return m_variant.get(); }
    FrameInputs& inputs() { return m_inputs; }
    const FrameInputs& inputs() const { return m_inputs; }

    /// Also draws a variant. It has only its values yet, so it is alone. On failure (out of memory)
    /// no variant is drawn.
    Result<void> start_variant(const Values& values);
    void end_variant();
    /// Whether source, images and draws apply only to the variant, until it has the past of the
    /// picture.
    bool is_variant_alone() const { return m_is_variant_alone; }
    void set_variant_alone(bool is_alone) { m_is_variant_alone = is_alone && m_variant; }

    using Act = std::function<Result<void>(Executor&)>;
    /// Acts on picture and variant. If the variant fails it is removed, and the picture continues.
    Result<void> for_both(const Act& act);
    /// The same, or only on a variant that is alone.
    Result<void> for_drawn(const Act& act);

    /// `pixel_aspect` and `raster` are as in FrameInputs.
    Result<void> set_source(const Picture& picture, double pixel_aspect = 1.0,
                            const std::optional<SourceRaster>& raster = {});
    Result<void> set_image(const std::string& name, const Picture& picture);
    /// The same, with a texture from image_texture().
    void set_image(const std::string& name, const std::shared_ptr<const gpu::Texture>& texture);

    /// Draws a frame, or begins to: see Executor.
    void draw(const PlayedFrame& played, const Beam& beam,
              const std::vector<bool>* passes = nullptr, Slices slices = Slices::none);
    /// Redraws these passes of the current frame.
    void redraw(const PlayedFrame& played, const Beam& beam, const std::vector<bool>& passes,
                Slices slices = Slices::none);

private:
    Frame next_frame(const PlayedFrame& played, const Beam& beam) const;

    Executor m_picture;
    std::unique_ptr<Executor> m_variant;
    FrameInputs m_inputs;
    bool m_is_variant_alone = false;
};

/// Values without modulation, and their modulations.
struct ModulatedValues {
    const Values& picture;
    const Values& variant;
    const Modulations& modulations;
    Tempo tempo = {};
    const CuePlan* cues = nullptr;  // of the picture; null: none
    double position = 0.0;          // of the cues
};
/// Sets the values of the frame that ends at `seconds`. Without modulations and cues nothing
/// changes. A null loudness is silence. Cues can change the sizes of targets: fails as
/// Executor::resize().
Result<void> modulate(Executors& executors, const ModulatedValues& values, double seconds,
                      const Loudness* loudness);

/// Draws only the passes that later frames depend on: the frame is not displayed.
void draw_unseen(Executors& executors, const PlayedFrame& played, const Beam& beam);
