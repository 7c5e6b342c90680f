// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_faults.h"

#include <algorithm>

namespace girdle {
namespace {

constexpr int kWrongWhereSparse = 4000000;
constexpr int kAttachesInDegrees = 330;
// Our models' widest range, of gh_axial, is 240 degrees = 4.2 rad. 4.2 degrees are 0.07 rad, and no
// arm that moves has a widest range of less than 11 degrees [rad].
constexpr double kNoRangeOfAShoulder_rad = 0.2;

// The widest range of the hinges that the instance drives [rad].
double WidestRange_rad(const ModelView& model, int instance) {
  double widest_rad = 0;
  for (int actuator = 0; actuator < model.nactuator; ++actuator) {
    if (model.actuator_plugin[actuator] != instance ||
        model.actuator_trntype[actuator] != model.engine->transmission_joint) {
      continue;
    }
    const int joint = model.actuator_trnid[2 * actuator];
    if (model.jnt_type[joint] == model.engine->joint_hinge) {
      widest_rad =
          std::max(widest_rad, model.jnt_range[2 * joint + 1] - model.jnt_range[2 * joint]);
    }
  }
  return widest_rad;
}

}  // namespace

std::string EngineFault(int version, const ModelView& model, int instance, bool is_sparse) {
  if (version == kWrongWhereSparse && is_sparse) {
    return "MuJoCo 4.0.0 solves sparse models wrongly, and this one is sparse. Add <option "
           "jacobian=\"dense\"/> to the model, or run another version";
  }
  if (version == kAttachesInDegrees) {
    const double widest_rad = WidestRange_rad(model, instance);
    if (widest_rad > 0 && widest_rad < kNoRangeOfAShoulder_rad) {
      return "MuJoCo 3.3.0 took the joint ranges of an attached model, in radians, for degrees. "
             "Set "
             "compiler.degree of the parent to False (in XML: <compiler angle=\"radian\"/>) before "
             "you "
             "attach, or run another version";
    }
  }
  return "";
}

}  // namespace girdle
