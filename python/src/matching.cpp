// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// match, prepare and explain.
#include <fmt/core.h>
#include <pybind11/stl.h>

#include <cmath>
#include <Eigen/LU>
#include <memory>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/scans.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/pipeline/preset.hpp"
#include "setsquare/report/match/report.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// A scan made into surfaces, with the scan itself, so that an answer can be drawn.
struct PreparedPyScan {
  std::shared_ptr<const Scan> scan;
  PreparedScan prepared;
};

/// The answer of a match, and what was matched.
struct PyMatch {
  MatchResult result;
  std::shared_ptr<const Scan> reference;
  std::shared_ptr<const Scan> current;
};

PreparedPyScan prepare_scan(const py::object& scan, const std::optional<double>& fov_deg) {
  PreparedPyScan made{scan_from(scan, fov_deg), {}};
  made.prepared = without_gil([&] { return prepare(*made.scan); });
  return made;
}

/// What is known of the motion: nothing where nothing is given.
MatchParams bounded_params(const std::optional<double>& max_translation_m,
                           const std::optional<double>& max_rotation_deg) {
  MatchParams params;
  if (max_translation_m) {
    require_not_negative(*max_translation_m, "max_translation_m");
    params.bounds.max_translation_m = *max_translation_m;
  }
  if (max_rotation_deg) {
    require_not_negative(*max_rotation_deg, "max_rotation_deg");
    params.bounds.max_rotation_rad = rad_from_deg(*max_rotation_deg);
  }
  params.validate();
  return params;
}

/// Two scans of which at least one is prepared.
PyMatch match_prepared(const py::object& reference,
                       const py::object& current,
                       const std::optional<double>& fov_deg,
                       Preset preset,
                       const MatchParams& params) {
  if (preset != Preset::kDefault) {
    throw ParameterError("preset", "prepared scans are matched by the default method");
  }
  std::optional<PreparedPyScan> made;
  const auto prepared_from = [&](const py::object& object) -> const PreparedPyScan& {
    if (py::isinstance<PreparedPyScan>(object)) return object.cast<const PreparedPyScan&>();
    made = prepare_scan(object, fov_deg);
    return *made;
  };
  const PreparedPyScan& a = prepared_from(reference);
  const PreparedPyScan& b = prepared_from(current);
  return {without_gil([&] { return match(a.prepared, b.prepared, params); }), a.scan, b.scan};
}

PyMatch match_scans(const py::object& reference,
                    const py::object& current,
                    const std::optional<double>& fov_deg,
                    const std::string& preset_name,
                    const std::optional<double>& max_translation_m,
                    const std::optional<double>& max_rotation_deg) {
  const Preset preset = preset_from(preset_name);
  const MatchParams params = bounded_params(max_translation_m, max_rotation_deg);
  if (py::isinstance<PreparedPyScan>(reference) || py::isinstance<PreparedPyScan>(current)) {
    return match_prepared(reference, current, fov_deg, preset, params);
  }
  if (preset == Preset::kPaper && (max_translation_m || max_rotation_deg)) {
    throw ParameterError("max_rotation_deg", "the preset \"paper\" knows no bounds");
  }
  PyMatch answer{{}, scan_from(reference, fov_deg), scan_from(current, fov_deg)};
  answer.result = without_gil([&] {
    return preset == Preset::kPaper ? match_paper(*answer.reference, *answer.current)
                                    : match(*answer.reference, *answer.current, params);
  });
  return answer;
}

std::string explain_match(const py::object& reference,
                          const py::object& current,
                          const std::optional<double>& fov_deg,
                          const std::string& preset_name,
                          const std::string& format) {
  const Preset preset = preset_from(preset_name);
  if (format != "html" && format != "svg") {
    throw ParameterError("format", "must be \"html\" or \"svg\"");
  }
  const auto scan_of = [&](const py::object& object) {
    return py::isinstance<PreparedPyScan>(object) ? object.cast<const PreparedPyScan&>().scan
                                                  : scan_from(object, fov_deg);
  };
  const std::shared_ptr<const Scan> a = scan_of(reference);
  const std::shared_ptr<const Scan> b = scan_of(current);
  return without_gil([&] {
    const StoryNames names{
        .log = "match", .reference = "reference scan", .current = "current scan"};
    const MatchStory story = preset == Preset::kPaper ? tell_paper_match(*a, *b, names)
                                                      : tell_default_match(*a, *b, names);
    return format == "svg" ? match_report_svg(story) : match_report_html(story);
  });
}

py::object covariance_of(const PyMatch& match) {
  if (!marginal_sigmas(match.result)) return py::none();
  return array_of<3, 3>(match.result.information.inverse());
}

std::string match_text(const PyMatch& match) {
  std::string text = fmt::format("MatchResult({}", to_string(match.result.status));
  if (match.result.T_reference_current) {
    const Pose2& pose = *match.result.T_reference_current;
    text += fmt::format(", x {:.3f} m, y {:.3f} m, theta {:.2f} deg, score {:.2f}",
                        pose.x_m,
                        pose.y_m,
                        deg_from_rad(pose.theta_rad),
                        match.result.score);
  }
  return text + ")";
}

/// A field of the answer, read-only.
template <typename Member>
auto field(Member MatchResult::*member) {
  return [member](const PyMatch& match) { return match.result.*member; };
}

void bind_match_result(py::module_& module) {
  py::class_<RunnerUp>(module, "RunnerUp", "The best proposal that differs from the answer.")
      .def_readonly("T_reference_current", &RunnerUp::T_reference_current, "Its pose.")
      .def_readonly("score", &RunnerUp::score, "As MatchResult.score.");
  py::class_<PyMatch>(module, "MatchResult", R"(The answer of a match, with its evidence.

Poses are those of the sensors at the middles of their sweeps:
p_reference = T_reference_current * p_current. NaN where the preset does not measure a field.)")
      .def_property_readonly(
          "status",
          [](const PyMatch& match) { return std::string(to_string(match.result.status)); },
          R"("matched", "ambiguous", "degenerate", "no_overlap", "too_few_points" or "rejected".)")
      .def_property_readonly(
          "is_matched",
          [](const PyMatch& match) { return match.result.status == MatchStatus::kMatched; },
          "Whether the pose is determined by the scans and stands alone.")
      .def_property_readonly("T_reference_current",
                             field(&MatchResult::T_reference_current),
                             "The best pose whatever the status; None where there is none.")
      .def_property_readonly(
          "information",
          [](const PyMatch& match) { return array_of<3, 3>(match.result.information); },
          R"(Inverse covariance of (x, y, theta) in the reference's frame, shape (3, 3).

In 1/m^2, 1/(m rad), 1/rad^2; singular where the match is degenerate.)")
      .def_property_readonly("covariance",
                             &covariance_of,
                             "Its inverse, shape (3, 3); None where the match is degenerate.")
      .def_property_readonly(
          "score", field(&MatchResult::score), "Agreement less the weighted contradiction.")
      .def_property_readonly("agreement",
                             field(&MatchResult::agreement),
                             "Share of the comparable returns that lie on the other's surfaces.")
      .def_property_readonly("contradiction",
                             field(&MatchResult::contradiction),
                             "Share of the returns that lie where the other scan saw through.")
      .def_property_readonly("overlap",
                             field(&MatchResult::overlap),
                             "Share of the current returns explained by the reference.")
      .def_property_readonly(
          "zncc_x", field(&MatchResult::zncc_x), "Along the dominant direction, [-1, 1].")
      .def_property_readonly("zncc_y", field(&MatchResult::zncc_y), "Across it.")
      .def_property_readonly("probability",
                             field(&MatchResult::probability),
                             "That the answer is right, within 0.2 m and 3 deg, of scans taken "
                             "within 5 m of each other.")
      .def_property_readonly("alias",
                             field(&MatchResult::alias),
                             "A motion in the reference's frame under which the place looks the "
                             "same (Pose2); else None.")
      .def_property_readonly("runner_up", field(&MatchResult::runner_up), "None where none is.")
      .def_property_readonly("degenerate_direction_rad",
                             field(&MatchResult::degenerate_direction_rad),
                             "Along which the pose is not determined, modulo pi; else None.")
      .def_property_readonly(
          "reference",
          [](const PyMatch& match) { return std::const_pointer_cast<Scan>(match.reference); },
          "The reference scan.")
      .def_property_readonly(
          "current",
          [](const PyMatch& match) { return std::const_pointer_cast<Scan>(match.current); },
          "The current scan.")
      .def("__repr__", &match_text);
}

}  // namespace

void bind_matching(py::module_& module) {
  py::class_<PreparedPyScan>(
      module, "PreparedScan", "A scan made into surfaces once, to be matched with many others.")
      .def_property_readonly(
          "scan",
          [](const PreparedPyScan& self) { return std::const_pointer_cast<Scan>(self.scan); },
          "The scan as it was measured.")
      .def("__repr__", [](const PreparedPyScan& self) {
        return fmt::format("PreparedScan({} beams)", self.scan->num_beams());
      });
  bind_match_result(module);
  module.def("prepare",
             &prepare_scan,
             py::arg("scan"),
             py::kw_only(),
             py::arg("fov_deg") = py::none(),
             R"(Makes a scan into surfaces, to match it with many others.

scan: a Scan, or an array of ranges (N,) in m over fov_deg degrees (180). Raises ParameterError.)");
  module.def("match",
             &match_scans,
             py::arg("reference"),
             py::arg("current"),
             py::kw_only(),
             py::arg("fov_deg") = py::none(),
             py::arg("preset") = "default",
             py::arg("max_translation_m") = py::none(),
             py::arg("max_rotation_deg") = py::none(),
             R"(Relative pose of two scans of which nothing is known; no initial guess.

reference, current: each a Scan, a PreparedScan, or an array of ranges (N,) in m over fov_deg
    degrees (180), symmetric about straight ahead, counterclockwise.
preset: "default", or "paper" for the method of Bando et al. 2014 as printed.
max_translation_m, max_rotation_deg: bounds of the motion, where they are known; poses beyond them
    are not considered, so that a square room is no longer ambiguous.

Returns a MatchResult whose status says whether the answer stands. Other threads run meanwhile.
Raises ParameterError where a scan's geometry is invalid.)");
  module.def("explain",
             &explain_match,
             py::arg("reference"),
             py::arg("current"),
             py::kw_only(),
             py::arg("fov_deg") = py::none(),
             py::arg("preset") = "default",
             py::arg("format") = "html",
             R"(One match as a page (format "html") or a picture ("svg"): what spoke for which pose.

Scans and preset as those of match, without bounds. Returns the document as text. Raises ParameterError.)");
}

}  // namespace setsquare::python
