// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The sections of an emitted model, in their order in the model.
///
/// Each function appends its section to the root element, or nothing if the model does not need it.
/// The comments name the file of each function.
#pragma once

#include "mjcf/model_plan.h"
#include "mjcf/xml_element.h"

namespace girdle {

// plugin_section.cc
void WriteExtension(const ModelPlan& plan, XmlElement root);  ///< the plugin's instances
void WriteSensors(const ModelPlan& plan,
                  XmlElement root);  ///< one sensor of the plugin for each side

// asset_section.cc
void WriteDefaults(const ModelPlan& plan, XmlElement root);
void WriteAssets(const ModelPlan& plan, XmlElement root);

// body_section.cc
void WriteBodies(const ModelPlan& plan, XmlElement root);

// anatomy_section.cc
void WriteAnatomy(const ModelPlan& plan, XmlElement root);  ///< for girdle verify

// skin_section.cc
void WriteSkin(const ModelPlan& plan, XmlElement root);

// constraint_section.cc
void WriteContacts(const ModelPlan& plan, XmlElement root);
void WriteEqualities(const ModelPlan& plan, XmlElement root);

// tendon_section.cc
void WriteLigaments(const ModelPlan& plan, XmlElement root);

// actuator_section.cc
void WriteActuators(const ModelPlan& plan, XmlElement root);

// keyframe_section.cc
void WriteKeyframes(const ModelPlan& plan, XmlElement root);

}  // namespace girdle
