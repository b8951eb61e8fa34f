#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/demo/window/knob.h"
#include "shading/material.h"

namespace scanlight::apps::window {

/// By what a person changes a value.
enum class Control { choice, slider, whole_slider, color, check };

/// How a slider's way is shared out.
enum class Scale { linear, logarithmic };

/// A value that can be changed while the picture is drawn: a key of scene files, with what a person
/// sees of it.
struct Parameter {
    std::string group;   // under which it stands
    std::string name;    // for a person, one of a kind: "shading", "light 2 falloff"
    std::string symbol;  // the chapter's letter, "K_a"; empty: it has none
    Knob knob;
    Control control = Control::choice;
    double low = 0.0;  // of a slider, which may be less than the key takes
    double high = 1.0;
    Scale scale = Scale::linear;
    std::vector<std::string> words = {};             // of a choice
    std::optional<std::size_t> light = {};           // whose it is; its place among them
    std::vector<shading::Illumination> models = {};  // that know it; empty: all
    /// Whether a picture has a use for it, whatever the model; empty: each has.
    std::function<bool(const SceneOptions&)> wanted = {};
    /// The nearest value that the key takes; empty: it takes any.
    std::function<Value(const Value&)> nearest = {};
    /// Takes back what was said; as the first word of a choice it is called `unsaid`.
    std::function<void(SceneOptions&)> clear = {};
    std::string unsaid = {};
    /// What holds for a material where the options say nothing.
    std::function<Value(const shading::Material<float>&)> actual = {};
    /// The chapter's number from the key's, and back, which is the same: t from 1 - t.
    std::function<double(double)> turned = {};
};

/// All of them, but for those of single lights.
std::vector<Parameter> parameters();

/// Those of a light.
std::vector<Parameter> light_parameters(std::size_t light);

/// Whether a picture of these options depends on it.
bool applies(const Parameter& parameter, const SceneOptions& options);

/// What is to be shown; none if there is no one value. `material` is that of the first surface.
std::optional<Value> shown_value(const Parameter& parameter, const SceneOptions& options,
                                 const shading::Material<float>& material);

/// The options with that value, or as they were if it is none for the key. For a choice the word
/// `unsaid` takes back what was said.
SceneOptions with_value(SceneOptions options, const Parameter& parameter, const Value& value);

}  // namespace scanlight::apps::window
