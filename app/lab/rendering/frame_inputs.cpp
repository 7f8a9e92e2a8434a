#include "lab/rendering/frame_inputs.h"

Frame frame_of(const FrameInputs& inputs, const PlayedFrame& played, const Beam& beam) {
    Frame frame;
    frame.time = played.span.end;
    frame.time_delta = played.span.seconds();
    frame.number = played.number;
    frame.mouse = inputs.input_state.position();
    frame.press = inputs.input_state.press();
    frame.keys = inputs.input_state.keys();
    frame.pixel_aspect = inputs.pixel_aspect;
    frame.source_raster = inputs.source_raster;
    frame.sample_budget_seconds = inputs.sample_budget_seconds;
    frame.subframe = played.subframe;
    frame.source_number = played.source_number;
    frame.is_whole = inputs.shows_whole;
    frame.hdr = inputs.hdr;
    frame.beam = beam;
    frame.beam_fit = inputs.beam_fit;
    frame.tints = beam.tints;
    frame.sound = inputs.sound.get();
    frame.date = inputs.date.value_or(date_after(date_of_renders, frame.time));
    return frame;
}
