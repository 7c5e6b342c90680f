// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/model_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "kinematics/lengths.h"
#include "names/longest_timestep.h"
#include "names/open_loop.h"
#include "names/unfit_joints.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// The lag of a servo is damping / stiffness, 20 ms in the emitted models [s]. Servos with a shorter
// lag ring; those with a longer one are slower than the arm.
constexpr double kUsualLag_s = 0.02;
constexpr double kShortestLag_s = 0.004;
constexpr double kLongestLag_s = 0.1;
// A stretch of a ligament beyond its slack with little effect: 20 N, which turn no joint by more
// than 0.02 degrees.
constexpr double kSlightStretch_m = 2e-4;
// Least lag of a joint while the arm moves up and down once a second.
constexpr double kOrdinaryError_rad = 0.1;
constexpr double kOrdinaryError_m = 0.01;
constexpr int kPolynomialTerms = 2;  // mjNPOLY

class FaultFinder {
 public:
  FaultFinder(const CompiledView& compiled, const RhythmBinding& binding,
              const AssembledRhythm& rhythm)
      : compiled_(compiled), model_(compiled.model), binding_(binding), rhythm_(rhythm) {}

  [[nodiscard]] std::string Find() {
    CheckRanges();
    CheckTimestep();
    CheckLoop();
    CheckForceRanges();
    CheckDamping();
    CheckSprings();
    CheckLigaments();
    return faults_;
  }

 private:
  void Add(const std::string& fault) {
    faults_ += (faults_.empty() || fault.empty() ? "" : "; ") + fault;
  }

  void CheckRanges() {
    double widest_rad = 0;
    for (const CoordinateRange& range : binding_.ranges) {
      widest_rad = std::max(widest_rad, range.upper_rad - range.lower_rad);
    }
    Add(RangesFault(widest_rad));
  }

  [[nodiscard]] DampingScheme Scheme() const {
    if (compiled_.integrator == model_.engine->integrator_rk4) {
      return DampingScheme::kRungeKutta;
    }
    const bool is_euler = compiled_.integrator == model_.engine->integrator_euler;
    return is_euler && model_.Disables(model_.engine->disable_eulerdamp)
               ? DampingScheme::kExplicitEuler
               : DampingScheme::kImplicit;
  }

  void CheckTimestep() { Add(TimestepFault(compiled_.timestep_s, binding_.assembly, Scheme())); }

  void CheckLoop() {
    if (binding_.assembly != Assembly::kLoop) {
      return;
    }
    const std::vector<int>& connects = binding_.closing_connects;
    Add(OpenLoopFault(
        {.constraints_are_disabled = model_.Disables(model_.engine->disable_constraint),
         .equalities_are_disabled = model_.Disables(model_.engine->disable_equality),
         .has_connect = !connects.empty(),
         .starts_inactive = std::none_of(connects.begin(), connects.end(), [this](int connect) {
           return compiled_.eq_active0[connect] != 0;
         })}));
  }

  [[nodiscard]] int ActuatorOf(const BoundServo& servo) const {
    int actuator = 0;
    while (model_.OutputOf(actuator) != servo.force_address) {
      ++actuator;
    }
    return actuator;
  }

  // Whether a range is narrower than a servo needs.
  static bool IsTight(mjtByte is_limited, const mjtNum* range, double needed) {
    return is_limited != 0 && (range[0] > -needed || range[1] < needed);
  }

  // Reports the first servo whose force is limited too far. The line in the message repairs all
  // servos.
  void CheckForceRanges() {
    for (const BoundServo* const servo : Servos()) {
      const int joint = model_.dof_jntid[servo->dof_address];
      const int actuator = ActuatorOf(*servo);
      const bool is_slide = model_.jnt_type[joint] == model_.engine->joint_slide;
      const double needed = servo->stiffness * (is_slide ? kOrdinaryError_m : kOrdinaryError_rad);
      const mjtNum* range = compiled_.jnt_actfrcrange + 2 * joint;
      std::string line = "actuatorfrclimited=\"false\" into <joint> of <default class=\"girdle\">";
      if (!IsTight(compiled_.jnt_actfrclimited[joint], range, needed)) {
        range = compiled_.actuator_forcerange + 2 * actuator;
        // Defaults of a body's class do not apply to actuators.
        line = "forcelimited=\"false\" into each of the shoulder's <plugin> in <actuator>";
        if (!IsTight(compiled_.actuator_forcelimited[actuator], range, needed)) {
          continue;
        }
      }
      Add(JointName(*servo) + " gets no more than " + SignificantText(range[0], 3) + " to " +
          SignificantText(range[1], 3) + (is_slide ? " N" : " N m") +
          " of its servo, which needs " + SignificantText(needed, 3) + " where it lags by " +
          (is_slide ? "10 mm" : "0.1 rad") + ": write " + line);
      return;
    }
  }

  // Returns the servos of all driven joints. Stiffness is in N m/rad, for slides in N/m.
  [[nodiscard]] std::vector<const BoundServo*> Servos() const {
    std::vector<const BoundServo*> servos;
    servos.reserve(binding_.servos.size() + binding_.place_servos.size());
    for (const BoundServo& servo : binding_.servos) {
      servos.push_back(&servo);
    }
    for (std::size_t i = 0; binding_.has_place_servos && i < binding_.place_servos.size(); ++i) {
      servos.push_back(&binding_.place_servos[i]);
    }
    return servos;
  }

  [[nodiscard]] std::string JointName(const BoundServo& servo) const {
    return "joint \"" +
           std::string(model_.names + compiled_.name_jntadr[model_.dof_jntid[servo.dof_address]]) +
           "\"";
  }

  static bool HasTerms(const mjtNum* polynomials, int element) {
    return polynomials != nullptr && std::any_of(polynomials + kPolynomialTerms * element,
                                                 polynomials + kPolynomialTerms * (element + 1),
                                                 [](mjtNum term) { return term != 0; });
  }

  void CheckDamping() {
    if (model_.Disables(model_.engine->disable_damper)) {
      Add(kDisabledDamperFault);
      return;
    }
    for (const BoundServo* const servo : Servos()) {
      const double lag_s = model_.dof_damping[servo->dof_address] / servo->stiffness;
      if (servo->stiffness > 0 && !(lag_s >= kShortestLag_s && lag_s <= kLongestLag_s)) {
        Add(JointName(*servo) + " has damping " +
            SignificantText(model_.dof_damping[servo->dof_address], 3) + " at a stiffness kp of " +
            SignificantText(servo->stiffness, 3) + ": write damping=\"" +
            SignificantText(kUsualLag_s * servo->stiffness, 3) + "\" there");
        return;
      }
    }
  }

  // Reports the first joint with a property that only a parent's defaults can give it. The line in
  // the message repairs all joints.
  void CheckSprings() {
    for (const BoundServo* const servo : Servos()) {
      const int dof = servo->dof_address;
      const int joint = model_.dof_jntid[dof];
      const bool curved_damping = HasTerms(compiled_.dof_dampingpoly, dof);
      const bool curved_spring = HasTerms(compiled_.jnt_stiffnesspoly, joint);
      const bool has_spring = curved_spring || compiled_.jnt_stiffness[joint] != 0;
      const bool has_friction = compiled_.dof_frictionloss[dof] != 0;
      if (!curved_damping && !has_spring && !has_friction) {
        continue;
      }
      std::string what;
      std::string line;
      const auto note = [&](const char* name, const std::string& attribute) {
        what += (what.empty() ? "" : " and ") + std::string(name);
        line += " " + attribute;
      };
      if (curved_damping) {
        note("nonlinear damping", "damping=\"0 0 0\"");
      }
      if (has_spring) {
        note("stiffness", curved_spring ? "stiffness=\"0 0 0\"" : "stiffness=\"0\"");
      }
      if (has_friction) {
        note("frictionloss", "frictionloss=\"0\"");
      }
      Add(JointName(*servo) + " has " + what +
          ", which a parent's defaults may have given it: write" + line +
          " into <joint> of <default class=\"girdle\">");
      return;
    }
  }

  // The ends of a tendon as sites, if it runs straight from the clavicle to the scapula.
  struct Ends {
    Vector3 on_clavicle_m;
    Vector3 on_scapula_m;
  };
  [[nodiscard]] std::optional<Ends> EndsOf(int tendon) const {
    const int first = compiled_.tendon_adr[tendon];
    if (compiled_.tendon_num[tendon] != 2 ||
        compiled_.wrap_type[first] != model_.engine->wrap_site ||
        compiled_.wrap_type[first + 1] != model_.engine->wrap_site) {
      return std::nullopt;
    }
    std::array<int, 2> sites = {compiled_.wrap_objid[first], compiled_.wrap_objid[first + 1]};
    if (model_.site_bodyid[sites[0]] == binding_.scapula_body) {
      std::swap(sites[0], sites[1]);
    }
    if (model_.site_bodyid[sites[0]] != binding_.clavicle_body ||
        model_.site_bodyid[sites[1]] != binding_.scapula_body) {
      return std::nullopt;
    }
    const auto place = [this](int site) {
      const mjtNum* const p = model_.site_pos + 3 * site;
      return OnSide(binding_.side, Vector3(p[0], p[1], p[2]));
    };
    return Ends{place(sites[0]), place(sites[1])};
  }

  // Returns the largest length of a ligament over the rhythm's domain [m]. The poses are at most
  // `apart_rad` apart.
  [[nodiscard]] double LongestLength_m(const Ends& ends, double apart_rad) const {
    const ArmRectangle& domain = rhythm_.rhythm().domain();
    const double planes_rad = domain.last_plane_rad - domain.first_plane_rad;
    const double elevations_rad = domain.highest_elevation_rad - domain.lowest_elevation_rad;
    const auto steps = [apart_rad](double length_rad) {
      return std::max(static_cast<int>(std::ceil(length_rad / apart_rad)), 1);
    };
    const int plane_steps = steps(planes_rad);
    const int elevation_steps = steps(elevations_rad);
    double longest_m = 0;
    for (int i = 0; i <= plane_steps; ++i) {
      // The last value is the bound itself, because a rounded sum may exceed it.
      const double plane_rad = i == plane_steps
                                   ? domain.last_plane_rad
                                   : domain.first_plane_rad + i * planes_rad / plane_steps;
      for (int j = 0; j <= elevation_steps; ++j) {
        const double elevation_rad =
            j == elevation_steps
                ? domain.highest_elevation_rad
                : domain.lowest_elevation_rad + j * elevations_rad / elevation_steps;
        const Quaternion q_CS = rhythm_.SolvePose({elevation_rad, plane_rad}).q_CS;
        longest_m = std::max(longest_m, glm::length(*binding_.p_CS_m + q_CS * ends.on_scapula_m -
                                                    ends.on_clavicle_m));
      }
    }
    return longest_m;
  }

  void CheckLigaments() {
    constexpr double kFarApart_rad = 15 * kRadiansPerDegree;
    for (int tendon = 0; binding_.p_CS_m && tendon < compiled_.ntendon; ++tendon) {
      const std::optional<Ends> ends = EndsOf(tendon);
      const double slack_m = compiled_.tendon_lengthspring[2 * tendon + 1];
      if (!ends || compiled_.tendon_stiffness[tendon] <= 0 ||
          LongestLength_m(*ends, kFarApart_rad) <= slack_m + kSlightStretch_m) {
        continue;
      }
      const double longest_m = RoundedUpLength_m(LongestLength_m(*ends, kRadiansPerDegree));
      const double tears_m = compiled_.tendon_range[2 * tendon + 1] + longest_m - slack_m;
      const std::string name = model_.names + compiled_.name_tendonadr[tendon];
      Add("tendon \"" + name + "\" is slack up to " + RoundedText(slack_m, kLengthDecimals) +
          " m, and the rhythm takes its sites " + RoundedText(longest_m, kLengthDecimals) +
          " m apart: write springlength=\"0 " + RoundedText(longest_m, kLengthDecimals) +
          "\" range=\"0 " + RoundedText(tears_m, kLengthDecimals) + "\" there");
    }
  }

  const CompiledView& compiled_;
  const ModelView& model_;
  const RhythmBinding& binding_;
  const AssembledRhythm& rhythm_;
  std::string faults_;
};

}  // namespace

std::string ModelFaults(const CompiledView& compiled, const RhythmBinding& binding,
                        const AssembledRhythm& rhythm) {
  return FaultFinder(compiled, binding, rhythm).Find();
}

}  // namespace girdle
