#pragma once

#include "base/diagnostic.h"
#include "model/look/parameter.h"
#include "model/look/spec.h"
#include "signals/signal/signal.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

class Settings;

enum class SettingType { number, word, text };

/// When a setting has an effect: while the word of another setting is one of these. No key: always.
struct SettingCondition {
    std::string key = {};
    std::vector<std::string> words = {};
};

/// One setting of a kind of signal, as shown in lists, controls and the manual.
struct SettingInfo {
    std::string key = {};
    std::string label = {};
    std::string unit = {};
    std::string help = {};
    SettingType type = SettingType::number;
    double low = 0.0;  // soft limits of a slider
    double high = 1.0;
    double step = 0.0;  // 0: any value; 1: whole numbers only
    double initial = 0.0;
    bool logarithmic = false;
    Limit limit = {-1e6, 1e6};            // numbers beyond it are an error
    std::vector<std::string> words = {};  // for type word: all allowed words
    std::string initial_word = {};        // for word and text; "" where a text is required
    std::string group = {};               // heading in the form; "": no heading
    SettingCondition condition = {};
    bool may_be_empty = false;  // for type text
    bool is_hidden = false;     // has no control of its own in a form
};

/// A setting with a few words to choose from. The first word is the default.
SettingInfo choice_setting(std::string key, std::string label, std::string help,
                           std::vector<std::string> words);
/// How a signal that draws in x and y fits into the picture: "look", "whole", "stretch" or "crop".
SettingInfo fit_setting(SettingCondition condition = {});
/// Puts the settings under a heading. They are used only while `condition` holds.
std::vector<SettingInfo> in_group(const std::string& group, const SettingCondition& condition,
                                  std::vector<SettingInfo> settings);

/// A kind of signal: its description, settings and factory.
struct SignalKind {
    using Make = Result<std::unique_ptr<Signal>> (*)(const Settings& settings,
                                                     const SignalMedia& media);

    std::string kind = {};
    std::string label = {};
    std::string help = {};
    std::vector<SettingInfo> settings = {};
    std::string file_setting = {};  // key of the setting that names a file; "": no file
    std::string bare_setting = {};  // key that a bare first word stands for; "": not allowed
    bool is_live = false;           // needs a live sound from an audio device
    bool is_sent = false;           // needs a beam sent by another program
    Make make = nullptr;
};

const SettingInfo* find_setting(const SignalKind& kind, std::string_view key);
/// Whether the setting has an effect in a completed spec.
bool is_used(const SettingInfo& setting, const Spec& completed_spec);
