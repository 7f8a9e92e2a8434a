#pragma once

#include <tuple>

class AudioControl;
class Automation;
class BackgroundJobs;
class ComparisonView;
class ContentCommands;
class Document;
class DrawingTool;
class FrameLoop;
class Lab;
class LookCommands;
class LookLoader;
class MediaInput;
class Messages;
class ParameterSettingsStore;
class PassControl;
class Player;
class PresetCommands;
class Previews;
class RemoteControl;
class RenderSize;
class Renderer;

/// The parts of the lab, to read.
struct LabParts {
    const Document* document;  // null until a look has been opened
    const Renderer* renderer;  // null until a look has been built
    const Player& player;
    const AudioControl& audio;
    const Messages& messages;
    const MediaInput& media;
    const RenderSize& size;
    const FrameLoop& frames;
    const LookLoader& loader;
    const LookCommands& looks;
    const PresetCommands& presets;
    const RemoteControl& remote;
    const DrawingTool& drawing;
    const Automation& automation;
    const BackgroundJobs& jobs;
};
LabParts parts_of(const Lab& lab);

/// Pointers to the parts of the lab to change; null: as in LabParts.
using MutableParts =
    std::tuple<AudioControl*, Automation*, BackgroundJobs*, ComparisonView*, ContentCommands*,
               Document*, DrawingTool*, FrameLoop*, LookCommands*, MediaInput*, Messages*,
               ParameterSettingsStore*, PassControl*, Player*, PresetCommands*, Previews*,
               RemoteControl*, RenderSize*, Renderer*>;
MutableParts mutable_parts(Lab& lab);
