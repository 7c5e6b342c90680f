// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/mapped_arm.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/worst_case.h"
#include "simulation/named_elements.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Newton's method ends at rounding, 1e-16 of a meter or a radian. This limit is far above that and
// far below anything that can be measured.
constexpr double kSolvedCoupling = 1e-9;
constexpr int kMostIterations = 40;
constexpr int kMostHalvings = 10;
// The held joints move to their places in steps so small that loops of bones stay on their branch.
constexpr double kLargestStep_rad = 5 * kRadiansPerDegree;
// Rounding: a joint may be this far beyond its range.
constexpr double kRangeRounding_rad = 1e-9;

// A model counts as at rest if it is this slow for this long.
constexpr double kRestDuration_s = 0.1;
constexpr double kLongestSettling_s = 10;

std::string Degrees(double angle_rad) { return RoundedText(DegreesFromRadians(angle_rad), 1); }

}  // namespace

MappedArm::MappedArm(mjModel& model, const ModelMapping& mapping)
    : model_(model), mapping_(mapping) {
  if (mapping.drives_are_actuators) {
    FindActuators();
  } else {
    FindJoints();
    ExpectNoFollowers();
    model.opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT | mjDSBL_FRICTIONLOSS;
    model.opt.jacobian = mjJAC_DENSE;
  }
  data_ = MakeData(model);
  mj_forward(&model_, data_.get());
}

void MappedArm::FindJoints() {
  std::vector<bool> held(static_cast<std::size_t>(model_.nv), false);
  for (const MappedDrive& drive : mapping_.drives) {
    const int id = FindElement(model_, mjOBJ_JOINT, drive.name, mapping_.file, drive.line);
    if (model_.jnt_type[id] != mjJNT_HINGE) {
      throw InputError(mapping_.file, drive.line,
                       "joint '" + drive.name + "' is not a hinge. Name hinges that set the arm");
    }
    ids_.push_back(id);
    addresses_.push_back(model_.jnt_qposadr[id]);
    held[static_cast<std::size_t>(model_.jnt_dofadr[id])] = true;
  }
  for (int dof = 0; dof < static_cast<int>(model_.nv); ++dof) {
    if (!held[static_cast<std::size_t>(dof)]) {
      free_dofs_.push_back(dof);
    }
  }
}

void MappedArm::FindActuators() {
  for (const MappedDrive& drive : mapping_.drives) {
    const int id = FindElement(model_, mjOBJ_ACTUATOR, drive.name, mapping_.file, drive.line);
    if (model_.actuator_ctrlnum[id] != 1) {
      throw InputError(mapping_.file, drive.line,
                       "actuator '" + drive.name + "' has " +
                           std::to_string(model_.actuator_ctrlnum[id]) +
                           " controls, expected 1. Name actuators with one control each");
    }
    ids_.push_back(id);
    addresses_.push_back(model_.actuator_ctrladr[id]);
  }
}

// Throws if the mapping sets a joint that the model's own constraints set.
void MappedArm::ExpectNoFollowers() const {
  for (int i = 0; i < static_cast<int>(model_.neq); ++i) {
    if (model_.eq_type[i] != mjEQ_JOINT || model_.eq_active0[i] == 0) {
      continue;
    }
    const auto found = std::find(ids_.begin(), ids_.end(), model_.eq_obj1id[i]);
    if (found == ids_.end()) {
      continue;
    }
    const MappedDrive& drive = mapping_.drives[static_cast<std::size_t>(found - ids_.begin())];
    const int leader = model_.eq_obj2id[i];
    const char* leader_name = leader < 0 ? nullptr : mj_id2name(&model_, mjOBJ_JOINT, leader);
    throw InputError(
        mapping_.file, drive.line,
        "joint '" + drive.name + "' " +
            (leader < 0 ? std::string("is held by an equality constraint")
                        : "follows joint '" + std::string(leader_name ? leader_name : "") +
                              "' by an equality constraint") +
            ". Name only joints that the model leaves free");
  }
}

ArmMove MappedArm::Move(const ArmAngles& wanted) {
  std::vector<double> values;
  values.reserve(mapping_.drives.size());
  for (const MappedDrive& drive : mapping_.drives) {
    values.push_back(drive.per_elevation * wanted.elevation_rad +
                     drive.per_plane * wanted.plane_rad + drive.per_axial * wanted.axial_rad +
                     drive.offset_rad);
  }
  ArmMove move;
  move.reason = BeyondRange(values);
  if (!move.reason.empty()) {
    return move;
  }
  if (is_lost_) {
    mj_resetData(&model_, data_.get());
  }
  move = moves_by_actuators() ? MoveActuators(values) : MoveJoints(values);
  is_lost_ = !move.reached;
  EngineWatch::ExpectNoWarning(mapping_.file + ": moving the arm to elevation " +
                               Degrees(wanted.elevation_rad) + ", plane " +
                               Degrees(wanted.plane_rad));
  return move;
}

std::string MappedArm::BeyondRange(const std::vector<double>& values) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    // Ranges of controls are indexed by control, those of joints by joint.
    const int id = moves_by_actuators() ? addresses_[i] : ids_[i];
    const bool is_limited =
        moves_by_actuators() ? model_.actuator_ctrllimited[id] != 0 : model_.jnt_limited[id] != 0;
    const mjtNum* range =
        (moves_by_actuators() ? model_.actuator_ctrlrange : model_.jnt_range) + 2 * id;
    if (is_limited &&
        (values[i] < range[0] - kRangeRounding_rad || values[i] > range[1] + kRangeRounding_rad)) {
      return mapping_.drives[i].name + " would be " + Degrees(values[i]) + ", its range is " +
             Degrees(range[0]) + " to " + Degrees(range[1]);
    }
  }
  return "";
}

double MappedArm::Coupling() const {
  double largest = 0;
  for (int row = 0; row < data_->ne; ++row) {
    largest = WorseOf(largest, std::abs(data_->efc_pos[row]));
  }
  return largest;
}

// Gauss-Newton with the smallest step: dq = -J^+ r. r has the residuals, and J is their Jacobian by
// the free degrees of freedom.
double MappedArm::SolveCouplings() {
  mj_fwdPosition(&model_, data_.get());
  double residual = Coupling();
  const auto nv = static_cast<std::size_t>(model_.nv);
  std::vector<mjtNum> step(nv);
  std::vector<mjtNum> start(static_cast<std::size_t>(model_.nq));
  for (int i = 0; i < kMostIterations && residual > kSolvedCoupling; ++i) {
    const int rows = data_->ne;
    Eigen::MatrixXd J(rows, static_cast<Eigen::Index>(free_dofs_.size()));
    Eigen::VectorXd r(rows);
    for (int row = 0; row < rows; ++row) {
      r[row] = data_->efc_pos[row];
      for (std::size_t k = 0; k < free_dofs_.size(); ++k) {
        J(row, static_cast<Eigen::Index>(k)) =
            data_->efc_J[static_cast<std::size_t>(row) * nv +
                         static_cast<std::size_t>(free_dofs_[k])];
      }
    }
    const Eigen::VectorXd dq = J.completeOrthogonalDecomposition().solve(-r);
    start.assign(data_->qpos, data_->qpos + model_.nq);
    double share = 1;
    double next = residual;
    for (int halving = 0; halving < kMostHalvings; ++halving) {
      std::copy(start.begin(), start.end(), data_->qpos);
      std::fill(step.begin(), step.end(), 0);
      for (std::size_t k = 0; k < free_dofs_.size(); ++k) {
        step[static_cast<std::size_t>(free_dofs_[k])] = dq[static_cast<Eigen::Index>(k)];
      }
      mj_integratePos(&model_, data_->qpos, step.data(), share);
      mj_fwdPosition(&model_, data_.get());
      next = Coupling();
      if (next < residual) {
        break;
      }
      share /= 2;
    }
    if (!(next < residual)) {
      break;
    }
    residual = next;
  }
  return residual;
}

ArmMove MappedArm::MoveJoints(const std::vector<double>& values) {
  std::vector<double> from;
  double farthest_rad = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    from.push_back(data_->qpos[addresses_[i]]);
    farthest_rad = std::max(farthest_rad, std::abs(values[i] - from[i]));
  }
  const int steps = std::max(1, static_cast<int>(std::ceil(farthest_rad / kLargestStep_rad)));
  ArmMove move;
  for (int step = 1; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    for (std::size_t i = 0; i < values.size(); ++i) {
      data_->qpos[addresses_[i]] = step == steps ? values[i] : std::lerp(from[i], values[i], share);
    }
    move.coupling = SolveCouplings();
  }
  move.reached = move.coupling <= kSolvedCoupling;
  if (!move.reached) {
    move.reason = "the model's equality constraints cannot be met, " +
                  SignificantText(move.coupling, 3) + " m or rad are left";
  }
  return move;
}

ArmMove MappedArm::MoveActuators(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    data_->ctrl[addresses_[i]] = values[i];
  }
  const double start_s = data_->time;
  double moved_s = data_->time;
  ArmMove move;
  while (data_->time - moved_s < kRestDuration_s && data_->time - start_s < kLongestSettling_s) {
    mj_step(&model_, data_.get());
    move.speed_rad_per_s = 0;
    for (int dof = 0; dof < static_cast<int>(model_.nv); ++dof) {
      move.speed_rad_per_s = WorseOf(move.speed_rad_per_s, std::abs(data_->qvel[dof]));
    }
    if (!(move.speed_rad_per_s < kRestSpeed_rad_per_s)) {
      moved_s = data_->time;
    }
  }
  // mj_step leaves derived quantities of the positions before the step.
  mj_forward(&model_, data_.get());
  move.coupling = Coupling();
  move.reached = data_->time - moved_s >= kRestDuration_s;
  if (!move.reached) {
    move.reason = "the model does not come to rest, after " + NumberText(kLongestSettling_s) +
                  " s it moves at " + SignificantText(move.speed_rad_per_s, 3) + " rad/s";
  }
  return move;
}

}  // namespace girdle
