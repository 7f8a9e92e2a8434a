#include "lab/frame/frame_values.h"

#include "lab/rendering/cued_frame.h"

void set_frame_values(Workspace& work, const PlayedFrame& frame, FrameDraw draw,
                      const DocumentState& applied, const Values* variant) {
    static const Values none;
    Executors& executors = work.renderer->executors();
    const PlayedSignal& signal = work.player.signal();
    const CuedFrame cued{work.cues.get(), frame.span, played_part(signal)};
    if (draw == FrameDraw::whole && cued.restarts())
        work.renderer->clear_history();
    cued.apply_blackout(executors);
    work.messages.succeeded(
        modulate(executors,
                 {applied.values, variant ? *variant : none, applied.modulations,
                  work.clock_tempo.value_or(applied.tempo), cued.plan(), cued.position()},
                 frame.span.end, signal.loudness().get()));
}
