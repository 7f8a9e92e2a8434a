#pragma once

#include "lab/renderer.h"

/// Reads the pictures that a person chose for samplers of the look, those that differ between the
/// two sets of values, and hands them to the renderer. A sampler whose choice is taken back, or
/// cannot be read, reads black.
Result<void> show_chosen_images(const Look& look, const Values& before, const Values& now,
                                Renderer& renderer);

/// Warnings about chosen pictures that are not there.
Diagnostics missing_images(const Look& look, const Values& values);
