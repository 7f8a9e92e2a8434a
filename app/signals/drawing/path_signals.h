#pragma once

#include "signals/drawing/scene.h"
#include "signals/signal/signal_kind.h"

class Settings;
struct DrawnSteps;

/// The scenes of these signals, with their settings applied.
BeamScene text_scene(const Settings& settings);
Result<BeamScene> file_scene(const SignalMedia& media, const Settings& settings);
Result<DrawnSteps> drawing_steps(const SignalMedia& media, const Settings& settings);

SignalKind text_kind();
SignalKind scene_kind();
SignalKind drawing_kind();
