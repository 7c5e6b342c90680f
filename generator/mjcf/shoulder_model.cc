// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/shoulder_model.h"

#include <array>
#include <string>

#include "mjcf/model_plan.h"
#include "mjcf/model_sections.h"
#include "mjcf/xml_element.h"

namespace girdle {
namespace {

constexpr double kTimestep_s = 0.002;

using WriteSection = void (*)(const ModelPlan& plan, XmlElement root);

// Sections in the order of the file.
constexpr std::array<WriteSection, 12> kSections = {
    WriteExtension, WriteDefaults,   WriteAssets,    WriteBodies,    WriteAnatomy, WriteSkin,
    WriteContacts,  WriteEqualities, WriteLigaments, WriteActuators, WriteSensors, WriteKeyframes};

void WriteComments(const ModelPlan& plan, XmlElement root) {
  const RhythmOptions& rhythm = plan.rhythm().options();
  const bool is_loop = plan.is_loop();
  root.AddComment(
      "Emitted by girdle generate. Interpolation " + std::string(Name(rhythm.interpolation)) +
      ", closure " + std::string(Name(rhythm.closure)) + ", range " +
      std::string(Name(*rhythm.range)) + ", table " +
      (plan.options.table  ? std::string(Name(*plan.options.table)) + " (Ludewig et al. 2009)"
       : plan.has_plugin() ? "in the plugin's configuration"
                           : "the user's own") +
      (is_loop ? ", assembly loop, the " + std::string(Name(plan.options.lead)) + " leads" : ""));
  root.AddComment("A joint coordinate is the measured Euler angle [rad]: SC and " +
                  std::string(is_loop ? "ST" : "AC") + " Y-X'-Z'', GH X-Z'-Y'', ISB frames" +
                  (is_loop ? "; the slides are PAC's place [m]" : "") +
                  "; qpos0 is where controls of zero lead");
}

}  // namespace

std::vector<Side> SidesOf(Sides sides) {
  switch (sides) {
    case Sides::kRight:
      return {Side::kRight};
    case Sides::kLeft:
      return {Side::kLeft};
    case Sides::kBoth:
      break;
  }
  return {Side::kRight, Side::kLeft};
}

std::string ShoulderModelXml(const Anatomy& anatomy, const ShoulderRhythm& rhythm,
                             const ShoulderModelOptions& options) {
  const ModelPlan plan(anatomy, rhythm, options);
  XmlFile file("mujoco");
  XmlElement root = file.root();
  root.Set("model", "girdle " + std::string(Name(options.sides)) +
                        (plan.sides.size() > 1 ? " shoulders" : " shoulder"));
  WriteComments(plan, root);
  root.Add("compiler").Set("angle", "radian");
  root.Add("option").Set("timestep", kTimestep_s).Set("integrator", "implicitfast");
  for (const WriteSection write : kSections) {
    write(plan, root);
  }
  return file.Text();
}

}  // namespace girdle
