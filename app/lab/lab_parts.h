#pragma once

#include "lab/messages/edit.h"

class DisplayPace;
class LookLoader;

/// The parts of the lab, to read.
struct LabParts {
    const Document* document;  // null until a look has been opened
    const Renderer* renderer;  // null until a look has been built
    const Player& player;
    const AudioControl& audio;
    const Messages& messages;
    const MediaInput& media;
    const LiveChoices& live;
    const RenderSize& size;
    const LookSender& sender;
    const DisplayPace& display;
    const FrameLoop& frames;
    const LookLoader& loader;
    const ExternalPrograms& programs;
    const LookCommands& looks;
    const PresetCommands& presets;
    const RemoteControl& remote;
    const DrawingTool& drawing;
    const Automation& automation;
    const BackgroundJobs& jobs;
    const Sequencer& sequencer;
};
LabParts parts_of(const Lab& lab);

/// All parts to change. `window` is null without a window; edits of it then do nothing.
MutableParts mutable_parts(Lab& lab, WindowState* window);
